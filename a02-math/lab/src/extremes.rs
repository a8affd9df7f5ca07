//! Stiff and extreme cases of vectors, angles and linear systems. Exact values
//! are computed from the given doubles, with 60 digits or with fractions.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};

use measure::Effort;
use measure::extremes::greatest;
use measure::extremes::{Absolute, Bound, Case, Equal, Fails, Holds, Id, Outcome, Protocol, Ulps};

use crate::experiments::{conditions, from_columns, refined};
use crate::protocol;
use a02_math::arrays::{array, vector};
use a02_math::{Direction, Mat3x3, Normal3, Vector3};

pub fn cases(_: Effort) -> Vec<Case> {
    [lengths(), angles(), systems()].concat()
}

/// A few rounding errors of numbers near 1.
const ROUNDING: Bound = Absolute(4.0 * f64::EPSILON);

fn normalized(id: Id, what: &str, v: Vector3, exact: impl Into<Outcome>) -> Case {
    let what = format!("normalise {what}");
    Case::new(id, what, exact, Ulps(1.0), v.normalized().map(array))
        .protocol(Fails, array(protocol::normalized(v)))
}

#[rustfmt::skip]
fn lengths() -> Vec<Case> {
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
            [1.0, 1.0, 0.0], ROUNDING, reflected(slanted, tall).map(array))
            .protocol(Fails, array(protocol::reflected_on(slanted, tall))),
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
        let lengths = [b.magnitude() - 1.0, c.magnitude() - 1.0];
        greatest([n.dot(b), n.dot(c), b.dot(c)].into_iter().chain(lengths))
    });
    let what = format!("glam's directions across {what}: defect");
    Case::new(id, what, 0.0, ROUNDING, defect)
}

/// The angle between two vectors, against the protocol's arc cosine.
fn angle(id: Id, what: &str, [a, b]: [[f64; 3]; 2], exact: f64) -> Case {
    let (a, b) = (vector(a), vector(b));
    let bound = if exact == 0.0 { Equal } else { Ulps(4.0) };
    let what = format!("angle between {what}");
    Case::new(id, what, exact, bound, a.angle(b))
        .condition((exact > 0.0).then_some(2.0 / exact))
        .protocol(Fails, protocol::angle_by_arc_cosine(a, b))
}

#[rustfmt::skip]
fn angles() -> Vec<Case> {
    let x_and = |x: f64, y: f64| [[1.0, 0.0, 0.0], [x, y, 0.0]];
    let slanted = |length: f64| [[length, 0.0, 0.0], [length, length, 0.0]];
    let (v, w) = (vector([2.0, 2.5, 10.0]), vector([0.5, 6.0, 4.0]));
    let (on, [a, b]) = (vector([-2.0, -7.0, 3.0]), slanted(1e-100).map(vector));
    vec![
        angle("F01", "x and x turned by 1e-5", x_and(0.999_999_999_95, 9.999_999_999_833_334e-6), 1e-5),
        angle("F02", "x and x turned by 1e-7", x_and(0.999_999_999_999_995, 9.999_999_999_999_982e-8), 1e-7),
        angle("F03", "x and x turned by 1e-8", x_and(1.0, 1e-8), 1e-8),
        angle("F04", "x and x turned by 1e-12", x_and(1.0, 1e-12), 1e-12),
        angle("F05", "x and x turned by pi - 1e-9", x_and(-1.0, 1e-9), 3.141_592_652_589_793),
        Case::new("F28", "angle between (2, 2.5, 10) and (0.5, 6, 4): the text returns the cosine",
            0.740_948_356_444_46, Ulps(4.0), v.angle(w)).protocol(Fails, protocol::angle(v, w)),
        angle("F29", "(1, 1, 1) and itself, the rounded cosine being above 1", [[1.0; 3]; 2], 0.0),
        angle("F30", "vectors of length 1e-200, 45 degrees", slanted(1e-200), FRAC_PI_4),
        angle("F31", "vectors of length 1e200, 45 degrees", slanted(1e200), FRAC_PI_4),
        Case::new("F32", "angle between vectors of length 1e-100, 45 degrees",
            FRAC_PI_4, Ulps(4.0), a.angle(b)),
        Case::new("F33", "(2, 2.5, 10) projected on (-2, -7, 3): 8.5/62 of it, not 8.5/sqrt 62",
            [-0.274_193_548_387_096_75, -0.959_677_419_354_838_7, 0.411_290_322_580_645_2],
            Ulps(2.0), v.projected_on(on).map(array))
            .protocol(Fails, array(protocol::projected_on(v, on))),
    ]
}

fn solved(id: Id, what: &str, exact: [f64; 3], (m, b): (Mat3x3, Vector3), says: Protocol) -> Case {
    let bound = Ulps(4.0);
    let case = Case::new(id, what, exact, bound, array(refined(m, b)));
    case.condition(conditions(m, b, vector(exact)).into_iter().reduce(f64::max))
        .protocol(says, array(protocol::cramer(m, b)))
}

#[rustfmt::skip]
fn systems() -> Vec<Case> {
    let example = Mat3x3::from_rows([[82.0, 45.0, 9.0], [27.0, 16.0, 3.0], [9.0, 5.0, 1.0]]);
    let flat = Mat3x3::from_rows([[0.1, 0.2, 0.3], [0.4, 0.5, 0.6], [0.7, 0.8, 0.9]]);
    vec![
        solved("K01", "the system of the text: (82, 45, 9; 27, 16, 3; 9, 5, 1) x = (1, 1, 0)",
            [1.0, 1.0, -14.0], (example, vector([1.0, 1.0, 0.0])), Holds),
        solved("K02", "three columns that are flat but for 2^-40, x = (1, 1, 1)",
            [1.0; 3], nearly_flat(), Fails),
        Case::new("K03", "determinant of (.1, .2, .3; .4, .5, .6; .7, .8, .9): 0 but for rounding",
            4.163_336_342_344_336e-18, Absolute(4.0 * f64::EPSILON), flat.determinant()),
    ]
}

/// The third column differs from the sum of the others by 2^-40 in one
/// coordinate: the sum of all columns is exact, and the solution is (1, 1, 1).
fn nearly_flat() -> (Mat3x3, Vector3) {
    // Truncated to 30 binary digits, so that sums of a few numbers are exact.
    let short = |x: f64| libm::scalbn(libm::scalbn(x, 30).floor(), -30);
    let [a, b] = [[0.3, 0.7, 0.9], [0.5, 0.2, 0.6]].map(|column| vector(column.map(short)));
    let c = a + b + vector([libm::scalbn(1.0, -40), 0.0, 0.0]);
    (from_columns(a, b, c), a + b + c)
}
