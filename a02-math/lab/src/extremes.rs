//! Stiff and extreme cases of vectors, angles and linear systems. Exact values
//! are computed from the given doubles, with 60 digits or with fractions.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};

use measure::Effort;
use measure::extremes::{
    Absolute, Bound, Case, Equal, Fails, Holds, Id, Known, Nothing, Number, Outcome, Protocol,
    Triple, Ulps, greatest,
};

use crate::condition::{Exact3, condition, condition_of_angle, cross, dot, three, unit};
use crate::exact::DoubleDouble;
use crate::experiments::{conditions, from_columns, refined};
use crate::protocol;
use a02_math::arrays::{array, vector};
use a02_math::{Direction, Mat3x3, Normal3, Vector3};

pub fn cases(_: Effort) -> Vec<Case> {
    [lengths(), angles(), systems()].concat()
}

/// A few rounding errors of numbers near 1.
const ROUNDING: Bound = Absolute(4.0 * f64::EPSILON);

fn normalized(id: Id, what: &str, v: Vector3, exact: Outcome) -> Case {
    let of_unit = condition(&one_long(v), |x| unit(three(x, 0)));
    let ours = v.normalized().map(array);
    let theirs = array(protocol::normalized(v));
    Case {
        id,
        what: format!("normalise {what}"),
        exact,
        bound: Ulps(1.0),
        condition: Known(of_unit),
        protocol: Fails,
        ..Case::of(ours, theirs)
    }
}

fn lengths() -> Vec<Case> {
    let v = vector([1.0, 2.0, 2.0]);
    let thirds = Triple([1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0]);
    let x = |x| vector([x, 0.0, 0.0]);
    let slanted = vector([1.0, -1.0, 0.0]);
    let tall = Normal3::new(0.0, 1.001, 0.0);
    let unit_slanted = slanted * FRAC_1_SQRT_2;
    let nearly_unit = Normal3::new(0.0, 1.0 + 1e-8, 0.0);
    vec![
        normalized("E18", "(1, 2, 2) * 1e-160", v * 1e-160, thirds),
        normalized("E19", "(1, 2, 2) * 1e-200", v * 1e-200, thirds),
        normalized("E20", "(1, 2, 2) * 1e154", v * 1e154, thirds),
        normalized("E21", "(5e-324, 0, 0)", x(5e-324), Triple([1.0, 0.0, 0.0])),
        normalized("E22", "(0, 0, 0)", x(0.0), Nothing),
        normalized("E23", "(inf, 0, 0)", x(f64::INFINITY), Nothing),
        Case {
            id: "F23",
            what: "reflect (1, -1, 0) on the normal (0, 1.001, 0)".into(),
            exact: Triple([1.0, 1.0, 0.0]),
            condition: Known(condition_of_reflection(slanted, tall)),
            bound: ROUNDING,
            protocol: Fails,
            ..Case::of(
                reflected(slanted, tall).map(array),
                array(protocol::reflected_on(slanted, tall)),
            )
        },
        Case {
            id: "F24",
            what: "length of (1, -1, 0) / sqrt 2 reflected on (0, 1 + 1e-8, 0)".into(),
            exact: Number(1.0),
            condition: Known(condition_of_reflected_length(unit_slanted, nearly_unit)),
            bound: ROUNDING,
            protocol: Fails,
            ..Case::of(
                reflected(unit_slanted, nearly_unit).map(Vector3::magnitude),
                protocol::reflected_on(unit_slanted, nearly_unit).magnitude(),
            )
        },
        perpendicular("F25", "-z", [0.0, 0.0, -1.0]),
        perpendicular(
            "F26",
            "(3.85e-4, 3.85e-4, -0.99999985)",
            [3.85e-4, 3.85e-4, -0.999_999_85],
        ),
        perpendicular("F27", "(1e-9, 1e-9, -1)", [1e-9, 1e-9, -1.0]),
    ]
}

/// The reflection of an incoming vector by the lesson, on the normalised normal.
fn reflected(d: Vector3, n: Normal3) -> Option<Vector3> {
    Some((-d).reflected_on(n.normalized()?))
}

/// The reflected vector, with 30 digits: `2 (n · v) n - v` for `v = -d` and n of length 1.
fn reflected_exactly(d: Exact3, n: Exact3) -> Exact3 {
    let n = unit(n);
    let twice = dot(d, n) * 2.0.into();
    [0, 1, 2].map(|i| d[i] - twice * n[i])
}

fn condition_of_reflection(d: Vector3, n: Normal3) -> f64 {
    let numbers = [array(d), array(n)].concat();
    condition(&numbers, |x| reflected_exactly(three(x, 0), three(x, 3)))
}

fn condition_of_reflected_length(d: Vector3, n: Normal3) -> f64 {
    let numbers = [array(d), array(n)].concat();
    condition(&numbers, |x| {
        let reflected = reflected_exactly(three(x, 0), three(x, 3));
        [dot(reflected, reflected).sqrt()]
    })
}

fn condition_of_projection(v: Vector3, on: Vector3) -> f64 {
    let numbers = [array(v), array(on)].concat();
    condition(&numbers, |x| {
        let (v, on) = (three(x, 0), three(x, 3));
        let fraction = dot(v, on) / dot(on, on);
        on.map(|x| x * fraction)
    })
}

/// The determinant of three rows, with 30 digits.
fn determinant(rows: &[DoubleDouble]) -> DoubleDouble {
    dot(three(rows, 0), cross(three(rows, 3), three(rows, 6)))
}

/// The two directions that glam finds perpendicular to a third, after Duff et
/// al.: Building an Orthonormal Basis, Revisited, 2017. They hold where an
/// older formula fails: near -z.
fn perpendicular(id: Id, what: &str, n: [f64; 3]) -> Case {
    let defect = vector(n).normalized().map(|n| {
        let (b, c) = n.to_glam().any_orthonormal_pair();
        let [b, c] = [b, c].map(Vector3::from_glam);
        let cosines = [n.dot(b), n.dot(c), b.dot(c)];
        let lengths = [b.magnitude() - 1.0, c.magnitude() - 1.0];
        greatest(cosines.into_iter().chain(lengths))
    });
    Case {
        id,
        what: format!("glam's directions across {what}: defect"),
        exact: Number(0.0),
        bound: ROUNDING,
        ours: defect.into(),
        ..Case::default()
    }
}

/// The vector in this direction of length 1: 30 digits do not reach all lengths, on which no angle depends.
fn one_long(v: Vector3) -> [f64; 3] {
    v.normalized().map(array).unwrap_or_default()
}

/// The angle between two vectors, against the protocol's arc cosine.
fn angle(id: Id, what: &str, [a, b]: [[f64; 3]; 2], exact: f64) -> Case {
    let (a, b) = (vector(a), vector(b));
    Case {
        id,
        what: format!("angle between {what}"),
        exact: Number(exact),
        bound: if exact == 0.0 { Equal } else { Ulps(4.0) },
        condition: (exact > 0.0)
            .then(|| condition_of_angle(one_long(a), one_long(b), exact))
            .into(),
        protocol: Fails,
        ..Case::of(a.angle(b), protocol::angle_by_arc_cosine(a, b))
    }
}

fn angles() -> Vec<Case> {
    let x_and = |x: f64, y: f64| [[1.0, 0.0, 0.0], [x, y, 0.0]];
    let slanted = |length: f64| [[length, 0.0, 0.0], [length, length, 0.0]];
    let (v, w) = (vector([2.0, 2.5, 10.0]), vector([0.5, 6.0, 4.0]));
    let on = vector([-2.0, -7.0, 3.0]);
    let [short, short_diagonal] = slanted(1e-100).map(vector);
    vec![
        angle(
            "F01",
            "x and x turned by 1e-5",
            x_and(0.999_999_999_95, 9.999_999_999_833_334e-6),
            1e-5,
        ),
        angle(
            "F02",
            "x and x turned by 1e-7",
            x_and(0.999_999_999_999_995, 9.999_999_999_999_982e-8),
            1e-7,
        ),
        angle("F03", "x and x turned by 1e-8", x_and(1.0, 1e-8), 1e-8),
        angle("F04", "x and x turned by 1e-12", x_and(1.0, 1e-12), 1e-12),
        angle(
            "F05",
            "x and x turned by pi - 1e-9",
            x_and(-1.0, 1e-9),
            3.141_592_652_589_793,
        ),
        Case {
            id: "F28",
            what: "angle between (2, 2.5, 10) and (0.5, 6, 4): the text returns the cosine".into(),
            exact: Number(0.740_948_356_444_46),
            condition: Known(condition_of_angle(array(v), array(w), 0.740_948_356_444_46)),
            bound: Ulps(4.0),
            protocol: Fails,
            ..Case::of(v.angle(w), protocol::angle(v, w))
        },
        angle(
            "F29",
            "(1, 1, 1) and itself, the rounded cosine being above 1",
            [[1.0; 3]; 2],
            0.0,
        ),
        angle(
            "F30",
            "vectors of length 1e-200, 45 degrees",
            slanted(1e-200),
            FRAC_PI_4,
        ),
        angle(
            "F31",
            "vectors of length 1e200, 45 degrees",
            slanted(1e200),
            FRAC_PI_4,
        ),
        Case {
            id: "F32",
            what: "angle between vectors of length 1e-100, 45 degrees".into(),
            exact: Number(FRAC_PI_4),
            condition: Known(condition_of_angle(
                one_long(short),
                one_long(short_diagonal),
                FRAC_PI_4,
            )),
            bound: Ulps(4.0),
            ours: short.angle(short_diagonal).into(),
            ..Case::default()
        },
        Case {
            id: "F33",
            what: "(2, 2.5, 10) projected on (-2, -7, 3): 8.5/62 of it, not 8.5/sqrt 62".into(),
            exact: Triple([
                -0.274_193_548_387_096_75,
                -0.959_677_419_354_838_7,
                0.411_290_322_580_645_2,
            ]),
            condition: Known(condition_of_projection(v, on)),
            bound: Ulps(2.0),
            protocol: Fails,
            ..Case::of(
                v.projected_on(on).map(array),
                array(protocol::projected_on(v, on)),
            )
        },
    ]
}

/// A system `M x = b`, solved by Cramer's rule with refinement and without.
fn solved(id: Id, what: &str, system: &System, exact: [f64; 3], protocol: Protocol) -> Case {
    let System { m, b } = *system;
    let conditions = conditions(m, b, vector(exact));
    let ours = array(refined(m, b));
    let theirs = array(protocol::cramer(m, b));
    Case {
        id,
        what: what.into(),
        exact: Triple(exact),
        bound: Ulps(4.0),
        condition: conditions.into_iter().reduce(f64::max).into(),
        protocol,
        ..Case::of(ours, theirs)
    }
}

/// The system `M x = b`.
struct System {
    m: Mat3x3,
    b: Vector3,
}

fn systems() -> Vec<Case> {
    let example = System {
        m: Mat3x3::from_rows([[82.0, 45.0, 9.0], [27.0, 16.0, 3.0], [9.0, 5.0, 1.0]]),
        b: vector([1.0, 1.0, 0.0]),
    };
    let rows = [[0.1, 0.2, 0.3], [0.4, 0.5, 0.6], [0.7, 0.8, 0.9]];
    let numbers = rows.concat();
    let of_determinant = condition(&numbers, |x| [determinant(x)]);
    let exact_numbers: Vec<_> = numbers.iter().map(|x| DoubleDouble::from(*x)).collect();
    vec![
        solved(
            "K01",
            "the system of the text: (82, 45, 9; 27, 16, 3; 9, 5, 1) x = (1, 1, 0)",
            &example,
            [1.0, 1.0, -14.0],
            Holds,
        ),
        solved(
            "K02",
            "three columns that are flat but for 2^-40, x = (1, 1, 1)",
            &nearly_flat(),
            [1.0; 3],
            Fails,
        ),
        Case {
            id: "K03",
            what: "determinant of (.1, .2, .3; .4, .5, .6; .7, .8, .9), whose sign the rounding of the \
                   given numbers decides"
                .into(),
            exact: Number(4.163_336_342_344_336e-18),
            // A change of the given numbers in their last place: far more than the determinant itself.
            bound: Ulps(of_determinant),
            condition: Known(of_determinant),
            certified: Some(Number(determinant(&exact_numbers).value())),
            ours: Mat3x3::from_rows(rows).determinant().into(),
            ..Case::default()
        },
    ]
}

/// The third column differs from the sum of the others by 2^-40 in one
/// coordinate: the sum of all columns is exact, and the solution is (1, 1, 1).
fn nearly_flat() -> System {
    // Truncated to 30 binary digits, so that sums of a few numbers are exact.
    let short = |x: f64| libm::scalbn(libm::scalbn(x, 30).floor(), -30);
    let [a, b] = [[0.3, 0.7, 0.9], [0.5, 0.2, 0.6]].map(|column| vector(column.map(short)));
    let c = a + b + vector([libm::scalbn(1.0, -40), 0.0, 0.0]);
    System {
        m: from_columns(a, b, c),
        b: a + b + c,
    }
}
