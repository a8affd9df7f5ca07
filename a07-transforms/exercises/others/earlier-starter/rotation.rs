//! A turn about any axis, made of the three turns that are known.

use crate::prelude::*;

/// Turns about an axis through the origin by an angle in radians: counterclockwise, seen by
/// an eye to which the axis points. The axis has any length but 0.
pub fn rotation(axis: Vector3, angle: f64) -> Result<Transform, ArgumentError> {
    let k = axis.unit("axis")?;
    // Bring the axis to x, turn about x, and bring it back.
    let around = libm::atan2(k.z(), k.x());
    let up = libm::atan2(k.y(), libm::hypot(k.x(), k.z()));
    let back = Transform::IDENTITY.rotate_y(-around)?.rotate_z(up)?;
    back.rotate_x(angle)?.rotate_z(-up)?.rotate_y(around)
}

testing::examples! {
    let quarter = |axis: Vector3, v: Vector3| {
        let turn = rotation(axis, FRAC_PI_2).unwrap();
        (turn.matrix() * v).to_glam().to_array()
    };
    let [x, y, z] = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
        .map(|(x, y, z)| Vector3::new(x, y, z));
    assert_close(quarter(z, x), [0.0, 1.0, 0.0]);
    assert_close(quarter(x, y), [0.0, 0.0, 1.0]);
    assert_close(quarter(y * 2.0, z), [1.0, 0.0, 0.0]);
    assert_close(quarter(-z, x), [0.0, -1.0, 0.0]);
}
