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

/// On whole numbers of ordinary size the formulas give what they say, so that
/// nothing but the extreme cases makes them fail there.
#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ordinary_vectors_give_what_the_formulas_say() {
        let (a, b) = (Vector3::new(3.0, 4.0, 0.0), Vector3::new(0.0, 2.0, 0.0));
        assert_eq!(normalized(b), Vector3::new(0.0, 1.0, 0.0));
        assert_eq!(angle(a, b), 0.8);
        assert_eq!(angle_by_arc_cosine(a, b), libm::acos(0.8));
        assert_eq!(projected_on(a, b), Vector3::new(0.0, 8.0, 0.0));
        let n = Normal3::new(0.0, 1.0, 0.0);
        assert_eq!(reflected_on(a, n), Vector3::new(3.0, -4.0, 0.0));
        let twice = Normal3::new(0.0, 2.0, 0.0);
        assert_eq!(reflected_on(a, twice), Vector3::new(3.0, -28.0, 0.0));
    }

    #[test]
    fn a_system_gives_its_solution() {
        let m = Mat3x3::from_rows([[2.0, 1.0, 0.0], [0.0, 4.0, 1.0], [1.0, 0.0, 1.0]]);
        let solution = Vector3::new(1.0, -2.0, 3.0);
        assert_eq!(m.determinant(), 9.0);
        assert_eq!(cramer(m, m * solution), solution);
    }
}
