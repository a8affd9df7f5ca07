//! A vector, turned around an axis.

use crate::prelude::*;

/// The vector `v`, turned by `angle` in radians around an `axis` of any length:
/// to the left for an eye towards which the axis points. Around no axis, which
/// is the zero vector, nothing turns.
///
/// `u.dot(v)` and `u.cross(v)` are the products of vectors; `u.normalized()` is `None` for the zero vector.
pub fn rotated(v: Vector3, axis: Vector3, angle: f64) -> Vector3 {
    missing!("the turned vector", v, {
        let Some(k) = axis.normalized() else {
            return v;
        };
        let (sin, cos) = libm::sincos(angle);
        // Rodrigues (1840): the part along the axis stays, the rest turns.
        let along = k * k.dot(v);
        along + (v - along) * cos + k.cross(v) * sin
    })
}

testing::examples! {
    let v = Vector3::new(1.0, 2.0, 3.0);
    let turned = |axis, degrees: f64| array(rotated(v, axis, degrees.to_radians()));
    assert_close!(turned(Vector3::new(0.0, 0.0, 1.0), 90.0), [-2.0, 1.0, 3.0]);
    assert_close!(turned(Vector3::new(0.0, 0.0, -9.0), 90.0), [2.0, -1.0, 3.0]);
    assert_close!(turned(Vector3::default(), 90.0), [1.0, 2.0, 3.0], "around no axis");
}
