//! `angle`: the angle between two vectors.

use crate::prelude::*;

/// The angle between two vectors of any length in radians, from 0 to π. The angle to
/// the zero vector is 0.
///
/// `a.dot(b)`, `a.cross(b)` and `a.magnitude()` are written; of the functions of angles,
/// use the functions of `libm`: `libm::acos(x)`, `libm::atan2(y, x)`.
pub fn angle(a: Vector3, b: Vector3) -> f64 {
    let sine = a.cross(b).magnitude();
    let cosine = a.dot(b);
    libm::atan2(sine, cosine)
}
