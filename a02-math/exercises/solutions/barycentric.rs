//! Barycentric coordinates: a point as a mixture of three corners.

use crate::prelude::*;

/// The weights of the corners `a`, `b` and `c` in the point `p` of their plane:
/// `p = α a + β b + γ c` with `α + β + γ = 1`. A point beside the plane has
/// the weights of the foot of its perpendicular. None if the corners are on a line.
///
/// `u.dot(v)` and `u.cross(v)` are the products of vectors.
pub fn barycentric(p: Point3, [a, b, c]: [Point3; 3]) -> Option<[f64; 3]> {
    missing!("the weights of the corners", None, {
        let n = (b - a).cross(c - a);
        let whole = n.dot(n);
        // Areas that keep their sign: turned against n they are negative.
        let beta = (p - a).cross(c - a).dot(n) / whole;
        let gamma = (b - a).cross(p - a).dot(n) / whole;
        (whole > 0.0).then_some([1.0 - beta - gamma, beta, gamma])
    })
}

testing::examples! {
    let corners = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)].map(|(x, y)| Point3::new(x, y, 5.0));
    let weights = |x, y, z| barycentric(Point3::new(x, y, z), corners);
    assert_close!(weights(4.0, 0.0, 5.0), Some([0.0, 1.0, 0.0]), "the corner b");
    assert_close!(weights(1.0, 1.0, 5.0), Some([0.5, 0.25, 0.25]), "inside");
    assert_close!(weights(1.0, 1.0, 9.0), Some([0.5, 0.25, 0.25]), "above it");
    assert_close!(weights(8.0, 0.0, 5.0), Some([-1.0, 2.0, 0.0]), "outside");
    assert!(barycentric(corners[0], [corners[0]; 3]).is_none(), "none without a triangle");
}
