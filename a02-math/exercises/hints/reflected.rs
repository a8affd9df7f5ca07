//! `reflected`: a vector, mirrored by a surface.

use crate::prelude::*;

/// The vector `v`, which points away from a surface, reflected about the normal `n` of
/// length 1: as far from the normal, on its other side.
///
/// `Vector3::from(n)` is the normal as a vector, which has a sum and multiples.
pub fn reflected(v: Vector3, n: Normal3) -> Vector3 {
    let along = Vector3::from(n) * n.dot(v);
    let rest = v - along;
    along - rest
}
