//! Refraction: the direction in which a ray goes on in water or glass.

use a02_math::{Direction, Normal3, Vector3};

/// The direction of length 1 behind a surface with the normal `n`, or none if
/// all light is mirrored. Both `d` and `n` have the length 1; `n` points out,
/// and `d` goes in or out. Outside the refractive index is 1, inside it is
/// `index`.
pub fn refracted(d: Vector3, n: Normal3, index: f64) -> Option<Vector3> {
    testing::missing("the direction behind the surface", Some(d))
}
