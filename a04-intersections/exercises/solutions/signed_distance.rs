//! How far a point is from a plane, and on which side.

use crate::prelude::*;

/// The distance of `p` from the plane through `a` with a normal `n` of any length but 0:
/// positive on the side that `n` points to, negative on the far side, and 0 in the plane.
///
/// `v.dot(n)` is a dot product, `Vector3::from(n)` the normal as a vector, and `v.magnitude()` a length.
pub fn signed_distance(a: Point3, n: Normal3, p: Point3) -> f64 {
    missing!("the distance from the plane, with its sign", f64::NAN, {
        // The dot product counts in the length of the normal.
        (p - a).dot(n) / Vector3::from(n).magnitude()
    })
}

testing::examples! {
    let a = Point3::new(7.0, -1.0, 0.0);
    let from = |n, y| signed_distance(a, Normal3::new(0.0, n, 0.0), Point3::new(0.0, y, 5.0));
    assert_close!(from(1.0, 0.0), 1.0, "on the side of the normal");
    assert_close!(from(1.0, -3.0), -2.0, "on the far side");
    assert_close!(from(1.0, -1.0), 0.0, "in the plane");
    assert_close!(from(2.0, 0.0), 1.0, "with a normal of length 2");
}
