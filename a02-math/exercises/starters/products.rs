//! `dot` and `cross`: the two products of vectors.

use crate::prelude::*;

/// The dot product: |a| |b| times the cosine of the angle between them.
///
/// The coordinates of a vector are `a.x()`, `a.y()` and `a.z()`.
pub fn dot(a: Vector3, b: Vector3) -> f64 {
    // 1. Multiply the two vectors coordinate by coordinate.
    // 2. Add the three products.
    testing::missing("the dot product", 0.0)
}

/// The cross product: perpendicular to both, by the right-hand rule. It is as long as
/// the parallelogram of both is large.
pub fn cross(a: Vector3, b: Vector3) -> Vector3 {
    // 1. For each coordinate, take the two others of both vectors, in the cyclic order x, y, z, x.
    // 2. Multiply them crosswise, and subtract.
    testing::missing("the cross product", Vector3::new(0.0, 0.0, 0.0))
}

testing::examples! {
    let [x, y] = [Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 1.0, 0.0)];
    let [a, b] = [Vector3::new(1.0, 2.0, 3.0), Vector3::new(4.0, 5.0, 6.0)];
    assert_eq!(dot(x, y), 0.0, "a right angle");
    assert_eq!(dot(a, b), 32.0, "4 + 10 + 18");
    assert_eq!(cross(x, y), Vector3::new(0.0, 0.0, 1.0), "x cross y is z");
    assert_eq!(cross(a, b), Vector3::new(-3.0, 6.0, -3.0));
}
