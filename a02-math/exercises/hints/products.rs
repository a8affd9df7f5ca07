//! `dot` and `cross`: the two products of vectors.

use crate::prelude::*;

/// The dot product: |a| |b| times the cosine of the angle between them.
///
/// The coordinates of a vector are `a.x()`, `a.y()` and `a.z()`.
pub fn dot(a: Vector3, b: Vector3) -> f64 {
    let x = a.x() * b.x();
    let y = a.y() * b.y();
    let z = a.z() * b.z();
    x + y + z
}

/// The cross product: perpendicular to both, by the right-hand rule. It is as long as
/// the parallelogram of both is large.
pub fn cross(a: Vector3, b: Vector3) -> Vector3 {
    let x = a.y() * b.z() - a.z() * b.y();
    let y = a.z() * b.x() - a.x() * b.z();
    let z = a.x() * b.y() - a.y() * b.x();
    Vector3::new(x, y, z)
}
