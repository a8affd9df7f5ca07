//! Barycentric coordinates: a point as a mixture of three corners.

use a02_math::{Direction, Point3};

/// The shares of the corners `a`, `b` and `c` in the point `p` of their plane:
/// `p = α a + β b + γ c` with `α + β + γ = 1`. A point beside the plane has
/// the shares of the foot of its perpendicular. None if the corners are on a line.
pub fn barycentric(p: Point3, [a, b, c]: [Point3; 3]) -> Option<[f64; 3]> {
    testing::missing("the shares of the corners", None)
}
