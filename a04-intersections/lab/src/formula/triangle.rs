//! The intersection of a line and a triangle.

use crate::line::Line;
use crate::number::{Number, Triple, cross, difference, dot};

/// Where a line meets the plane of a triangle.
#[derive(Clone, Copy, Debug)]
pub struct Meeting<N> {
    /// The parameter of the line.
    pub t: N,
    /// The weight of the second corner, b.
    pub beta: N,
    /// The weight of the third corner, c.
    pub gamma: N,
}

/// The formula of Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle
/// Intersection", 1997.
pub fn moeller_trumbore<N: Number>([a, b, c]: &[Triple<N>; 3], line: &Line<N>) -> Meeting<N> {
    let (ab, ac) = (difference(b, a), difference(c, a));
    let from_a = difference(&line.origin, a);
    let across = cross(&line.direction, &ac);
    let moment = cross(&from_a, &ab);
    let determinant = dot(&ab, &across);
    Meeting {
        t: dot(&ac, &moment) / determinant,
        beta: dot(&from_a, &across) / determinant,
        gamma: dot(&line.direction, &moment) / determinant,
    }
}
