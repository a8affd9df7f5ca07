//! The formulas of this stage as the two texts have them, mistakes included:
//! only to be measured against.

use crate::{Direction, Mat3x3, Normal3, Vector3};

/// A vector divided by its length, whose square leaves the range of numbers
/// below 1e-154 and above 1e154.
pub fn normalized(v: Vector3) -> Vector3 {
    v * (1.0 / v.dot(v).sqrt())
}

/// The second text's angle, which is the cosine of it.
pub fn angle(a: Vector3, b: Vector3) -> f64 {
    a.dot(b) / (a.magnitude() * b.magnitude())
}

/// The angle as the arc cosine: blind below 1e-8, and NaN where rounding makes
/// the cosine of parallel vectors greater than 1.
pub fn angle_by_arc_cosine(a: Vector3, b: Vector3) -> f64 {
    libm::acos(angle(a, b))
}

/// The projection that the second text's test expects: divided by the length
/// of `b`, not by its square.
pub fn projected_on(a: Vector3, b: Vector3) -> Vector3 {
    b * (a.dot(b) / b.magnitude())
}

/// The reflection of a vector that comes in, which changes its length where
/// the length of `n` is not 1.
pub fn reflected_on(d: Vector3, n: Normal3) -> Vector3 {
    d - n * (2.0 * n.dot(d))
}

// ANCHOR: cramer
/// Cramer's rule: NaN or infinity where the determinant is 0, and few digits
/// where it is small beside the columns.
pub fn cramer(m: Mat3x3, b: Vector3) -> Vector3 {
    let determinant = m.determinant();
    Vector3::new(
        m.change_col_1(b).determinant() / determinant,
        m.change_col_2(b).determinant() / determinant,
        m.change_col_3(b).determinant() / determinant,
    )
}
// ANCHOR_END: cramer
