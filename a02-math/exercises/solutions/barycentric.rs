//! Barycentric coordinates: a point as a mixture of three corners.

use a02_math::{Direction, Point3};

/// The shares of the corners `a`, `b` and `c` in the point `p` of their plane:
/// `p = α a + β b + γ c` with `α + β + γ = 1`. A point beside the plane has
/// the shares of the foot of its perpendicular. None if the corners are on a line.
pub fn barycentric(p: Point3, [a, b, c]: [Point3; 3]) -> Option<[f64; 3]> {
    let n = (b - a).cross(c - a);
    let whole = n.dot(n);
    // Areas that keep their sign: turned against n they are negative.
    let beta = (p - a).cross(c - a).dot(n) / whole;
    let gamma = (b - a).cross(p - a).dot(n) / whole;
    (whole > 0.0).then_some([1.0 - beta - gamma, beta, gamma])
}
