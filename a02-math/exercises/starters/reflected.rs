//! `reflected`: a vector, mirrored by a surface.
//!
//! Chapter: Vectors, points, normals, section "Reflection". To compare afterwards:
//! `a02-math/src/vector3.rs`.

use a02_math::{Direction, Normal3, Vector3};

/// The vector `v`, which points away from a surface, reflected about the normal `n` of
/// length 1: as far from the normal, on its other side.
///
/// `Vector3::from(n)` is the normal as a vector, which has a sum and multiples.
pub fn reflected(v: Vector3, n: Normal3) -> Vector3 {
    testing::missing("the reflected vector", v)
}
