//! The formulas of this stage as the two texts print them, mistakes included:
//! only for comparison.

use a02_math::{Direction, Mat3x3, Normal3, Vector3};

/// A vector divided by its length, whose square underflows below 1e-154 and
/// overflows above 1e154.
pub fn normalized(v: Vector3) -> Vector3 {
    v * (1.0 / v.dot(v).sqrt())
}

/// The second text's angle, which is in fact its cosine.
pub fn angle(a: Vector3, b: Vector3) -> f64 {
    a.dot(b) / (a.magnitude() * b.magnitude())
}

/// The angle as the arc cosine: 0 for angles below 1e-8, and NaN if rounding
/// makes the cosine of parallel vectors greater than 1.
pub fn angle_by_arc_cosine(a: Vector3, b: Vector3) -> f64 {
    libm::acos(angle(a, b))
}

/// The projection that the second text's test expects: divided by the length
/// of `b`, not by its square.
pub fn projected_on(a: Vector3, b: Vector3) -> Vector3 {
    b * (a.dot(b) / b.magnitude())
}

/// The reflection of an incoming vector, which changes its length if the length
/// of `n` is not 1.
pub fn reflected_on(d: Vector3, n: Normal3) -> Vector3 {
    d - n * (2.0 * n.dot(d))
}

// ANCHOR: cramer
/// Cramer's rule: NaN or infinity if the determinant is 0, and inaccurate if it
/// is small compared with the columns.
pub fn cramer(m: Mat3x3, b: Vector3) -> Vector3 {
    let determinant = m.determinant();
    Vector3::new(
        m.change_col_1(b).determinant() / determinant,
        m.change_col_2(b).determinant() / determinant,
        m.change_col_3(b).determinant() / determinant,
    )
}
// ANCHOR_END: cramer
