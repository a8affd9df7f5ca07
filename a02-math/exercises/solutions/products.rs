//! `dot` and `cross`: the two products of vectors.

use crate::prelude::*;

/// The dot product: |a| |b| times the cosine of the angle between them.
///
/// The coordinates of a vector are `a.x()`, `a.y()` and `a.z()`.
pub fn dot(a: Vector3, b: Vector3) -> f64 {
    // 1. Multiply the two vectors coordinate by coordinate.
    // 2. Add the three products.
    missing!("the dot product", 0.0, {
        let x = a.x() * b.x();
        let y = a.y() * b.y();
        let z = a.z() * b.z();
        x + y + z
    })
}

/// The cross product: perpendicular to both, by the right-hand rule. Its length is
/// the area of the parallelogram that they span.
pub fn cross(a: Vector3, b: Vector3) -> Vector3 {
    // 1. For each coordinate, take the two others of both vectors, in the cyclic order x, y, z, x.
    // 2. Multiply them crosswise, and subtract.
    missing!("the cross product", Vector3::new(0.0, 0.0, 0.0), {
        let x = a.y() * b.z() - a.z() * b.y();
        let y = a.z() * b.x() - a.x() * b.z();
        let z = a.x() * b.y() - a.y() * b.x();
        Vector3::new(x, y, z)
    })
}

testing::examples! {
    let [x, y] = [Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 1.0, 0.0)];
    let [a, b] = [Vector3::new(1.0, 2.0, 3.0), Vector3::new(4.0, 5.0, 6.0)];
    assert_close!(dot(x, y), 0.0, "a right angle");
    assert_close!(dot(a, b), 32.0, "4 + 10 + 18");
    assert_close!(array(cross(x, y)), [0.0, 0.0, 1.0], "x cross y is z");
    assert_close!(array(cross(a, b)), [-3.0, 6.0, -3.0]);
}
