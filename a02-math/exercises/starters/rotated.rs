//! A vector, turned around an axis.

use a02_math::{Direction, Vector3};

/// The vector `v`, turned by `angle` in radians around an `axis` of any length:
/// to the left for an eye towards which the axis points. Around no axis, which
/// is the zero vector, nothing turns.
pub fn rotated(v: Vector3, axis: Vector3, angle: f64) -> Vector3 {
    testing::missing("the turned vector", v)
}
