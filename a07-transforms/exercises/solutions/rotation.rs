//! A turn about any axis, made of the three turns that are known.

use crate::prelude::*;

/// Turns about an axis through the origin by an angle in radians: counterclockwise, seen by
/// an eye to which the axis points. The axis has any length but 0.
///
/// A vector has `x()`, `y()` and `z()`; `rotate_x(angle)?`, `rotate_y(angle)?` and `rotate_z(angle)?` chain a turn to
/// a transform.
pub fn rotation(axis: Vector3, angle: f64) -> Result<Transform, ArgumentError> {
    let k = axis.unit("axis")?;
    missing!("the turn about the axis", Ok(Transform::IDENTITY), {
        // Up from the plane y = 0, and around from z towards x, lies the axis. Turns
        // about the x axis lead down from z.
        let up = libm::atan2(k.y(), libm::hypot(k.x(), k.z()));
        let around = libm::atan2(k.x(), k.z());
        // Read from below: bring the axis to z, turn, and bring it back.
        let back = Transform::IDENTITY.rotate_y(around)?.rotate_x(-up)?;
        back.rotate_z(angle)?.rotate_x(up)?.rotate_y(-around)
    })
}

testing::examples! {
    let quarter = |axis: Vector3, v: Vector3| {
        let turn = rotation(axis, FRAC_PI_2).unwrap();
        array(turn.matrix() * v)
    };
    let [x, y, z] = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
        .map(|(x, y, z)| Vector3::new(x, y, z));
    assert_close!(quarter(z, x), [0.0, 1.0, 0.0]);
    assert_close!(quarter(x, y), [0.0, 0.0, 1.0]);
    assert_close!(quarter(y * 2.0, z), [1.0, 0.0, 0.0]);
    assert_close!(quarter(-z, x), [0.0, -1.0, 0.0]);
}
