//! A turn about any axis, made of the three turns that are known.

use a02_math::Vector3;
use a07_transforms::Transform;
use common::ArgumentError;

/// Turns about an axis through the origin by an angle in radians:
/// counterclockwise, seen by an eye to which the axis points. The axis has any
/// length but 0.
pub fn rotation(axis: Vector3, angle: f64) -> Result<Transform, ArgumentError> {
    let k = axis.unit("axis")?;
    testing::missing("the turn about the axis", Ok(Transform::IDENTITY))
}
