//! Vectors brought to length 1, and vectors that should have length 1.

use std::f64::consts::FRAC_1_SQRT_2;

use measure::extremes::{Absolute, Bound, Case, Fails, Id, Outcome, Ulps};

use super::vector;
use crate::lab::protocol;
use crate::{Direction, Normal3, Vector3};

/// A few rounding errors of numbers near 1.
const ROUNDING: Bound = Absolute(4.0 * f64::EPSILON);

fn normalized(id: Id, what: &str, v: Vector3, exact: impl Into<Outcome>) -> Case {
    let what = format!("normalise {what}");
    Case::new(id, what, exact, Ulps(1.0), v.normalized()).protocol(Fails, protocol::normalized(v))
}

#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
    let reflected = |d: Vector3, n: Normal3| n.normalized().map(|n| (-d).reflected_on(n));
    let (slanted, tall) = (vector([1.0, -1.0, 0.0]), Normal3::new(0.0, 1.001, 0.0));
    let (unit, nearly_unit) = (slanted * FRAC_1_SQRT_2, Normal3::new(0.0, 1.0 + 1e-8, 0.0));
    let (v, thirds) = (vector([1.0, 2.0, 2.0]), [1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0]);
    let x = |x| vector([x, 0.0, 0.0]);
    vec![
        normalized("E18", "(1, 2, 2) * 1e-160", v * 1e-160, thirds),
        normalized("E19", "(1, 2, 2) * 1e-200", v * 1e-200, thirds),
        normalized("E20", "(1, 2, 2) * 1e154", v * 1e154, thirds),
        normalized("E21", "(5e-324, 0, 0)", x(5e-324), [1.0, 0.0, 0.0]),
        normalized("E22", "(0, 0, 0)", x(0.0), Outcome::Nothing),
        normalized("E23", "(inf, 0, 0)", x(f64::INFINITY), Outcome::Nothing),
        Case::new("F23", "reflect (1, -1, 0) on the normal (0, 1.001, 0)",
            [1.0, 1.0, 0.0], ROUNDING, reflected(slanted, tall))
            .protocol(Fails, protocol::reflected_on(slanted, tall)),
        Case::new("F24", "length of (1, -1, 0) / sqrt 2 reflected on (0, 1 + 1e-8, 0)",
            1.0, ROUNDING, reflected(unit, nearly_unit).map(Vector3::magnitude))
            .protocol(Fails, protocol::reflected_on(unit, nearly_unit).magnitude()),
        perpendicular("F25", "-z", [0.0, 0.0, -1.0]),
        perpendicular("F26", "(3.85e-4, 3.85e-4, -0.99999985)", [3.85e-4, 3.85e-4, -0.999_999_85]),
        perpendicular("F27", "(1e-9, 1e-9, -1)", [1e-9, 1e-9, -1.0]),
    ]
}

/// The two directions that glam finds perpendicular to a third, after Duff et
/// al.: Building an Orthonormal Basis, Revisited, 2017. They hold where an
/// older formula fails: near -z.
fn perpendicular(id: Id, what: &str, n: [f64; 3]) -> Case {
    let defect = vector(n).normalized().map(|n| {
        let (b, c) = n.to_glam().any_orthonormal_pair();
        let (b, c) = (Vector3::from_glam(b), Vector3::from_glam(c));
        let angles = [n.dot(b), n.dot(c), b.dot(c)];
        let lengths = [b.magnitude() - 1.0, c.magnitude() - 1.0];
        let defects = angles.into_iter().chain(lengths).map(f64::abs);
        defects.fold(0.0, f64::max)
    });
    let what = format!("glam's directions across {what}: defect");
    Case::new(id, what, 0.0, ROUNDING, defect)
}
