//! Vectors brought to length 1, and vectors that should have length 1.

use measure::extremes::{Bound, Case, Outcome, Protocol};

use super::{triple, vector};
use crate::lab::protocol;
use crate::{Direction, Normal3, Vector3};

/// A few rounding errors of numbers near 1.
const ROUNDING: Bound = Bound::Absolute(4.0 * f64::EPSILON);

pub fn cases() -> Vec<Case> {
    let mut cases = normalized();
    cases.extend(reflected());
    cases.extend(perpendicular());
    cases
}

fn normalized() -> Vec<Case> {
    let row = |id, what: &str, exact: Outcome, v: Vector3| {
        let ours = v.normalized().map(triple);
        Case::new(
            id,
            format!("normalise {what}"),
            exact,
            Bound::Ulps(1.0),
            ours,
        )
        .protocol(Protocol::Fails, triple(protocol::normalized(v)))
    };
    let thirds = || Outcome::from([1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0]);
    let v = vector([1.0, 2.0, 2.0]);
    let x = |x| vector([x, 0.0, 0.0]);
    vec![
        row("E18", "(1, 2, 2) * 1e-160", thirds(), v * 1e-160),
        row("E19", "(1, 2, 2) * 1e-200", thirds(), v * 1e-200),
        row("E20", "(1, 2, 2) * 1e154", thirds(), v * 1e154),
        row("E21", "(5e-324, 0, 0)", [1.0, 0.0, 0.0].into(), x(5e-324)),
        nothing("E22", "(0, 0, 0)", x(0.0)),
        nothing("E23", "(inf, 0, 0)", x(f64::INFINITY)),
    ]
}

/// A vector without direction.
fn nothing(id: &'static str, what: &str, v: Vector3) -> Case {
    let what = format!("normalise {what}");
    let ours = v.normalized().map(triple);
    Case::new(id, what, Outcome::Nothing, Bound::Equal, ours)
        .protocol(Protocol::Fails, triple(protocol::normalized(v)))
}

fn reflected() -> Vec<Case> {
    let ours = |d: Vector3, n: Normal3| n.normalized().map(|n| (-d).reflected_on(n));
    let (slanted, tall) = (vector([1.0, -1.0, 0.0]), Normal3::new(0.0, 1.001, 0.0));
    let unit = slanted * std::f64::consts::FRAC_1_SQRT_2;
    let nearly_unit = Normal3::new(0.0, 1.0 + 1e-8, 0.0);
    vec![
        Case::new(
            "F23",
            "reflect (1, -1, 0) on the normal (0, 1.001, 0)",
            [1.0, 1.0, 0.0],
            ROUNDING,
            ours(slanted, tall).map(triple),
        )
        .protocol(
            Protocol::Fails,
            triple(protocol::reflected_on(slanted, tall)),
        ),
        Case::new(
            "F24",
            "length of (1, -1, 0) / sqrt 2 reflected on (0, 1 + 1e-8, 0)",
            1.0,
            ROUNDING,
            ours(unit, nearly_unit).map(Vector3::magnitude),
        )
        .protocol(
            Protocol::Fails,
            protocol::reflected_on(unit, nearly_unit).magnitude(),
        ),
    ]
}

/// The two directions that glam finds perpendicular to a third, after Duff et
/// al.: Building an Orthonormal Basis, Revisited, 2017. They hold where an
/// older formula fails: near -z.
fn perpendicular() -> Vec<Case> {
    let row = |id, what: &str, n: [f64; 3]| {
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
    };
    vec![
        row("F25", "-z", [0.0, 0.0, -1.0]),
        row(
            "F26",
            "(3.85e-4, 3.85e-4, -0.99999985)",
            [3.85e-4, 3.85e-4, -0.999_999_85],
        ),
        row("F27", "(1e-9, 1e-9, -1)", [1e-9, 1e-9, -1.0]),
    ]
}
