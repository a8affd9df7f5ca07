//! How far a point is from a plane, and on which side.

use a02_math::{Direction, Normal3, Point3, Vector3};

/// The distance of `p` from the plane through `a` with a normal `n` of any
/// length but 0: positive on the side that `n` points to, negative on the far
/// side, and 0 in the plane.
pub fn signed_distance(a: Point3, n: Normal3, p: Point3) -> f64 {
    testing::missing("the distance from the plane, with its sign", f64::NAN)
}
