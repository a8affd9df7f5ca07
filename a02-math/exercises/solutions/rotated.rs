//! A vector, turned around an axis.

use a02_math::{Direction, Vector3};

/// The vector `v`, turned by `angle` in radians around an `axis` of any length:
/// to the left for an eye towards which the axis points. Around no axis, which
/// is the zero vector, nothing turns.
pub fn rotated(v: Vector3, axis: Vector3, angle: f64) -> Vector3 {
    let Some(k) = axis.normalized() else {
        return v;
    };
    let (sin, cos) = libm::sincos(angle);
    // Rodrigues (1840): the part along the axis stays, the rest turns.
    let along = k * k.dot(v);
    along + (v - along) * cos + k.cross(v) * sin
}
