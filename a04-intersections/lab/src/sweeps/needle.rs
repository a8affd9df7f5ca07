//! A triangle that becomes a needle.

use measure::exact::DoubleDouble;
use measure::extremes::AgainstProtocol;
use measure::sweep::{Point, Sweep};

use super::{against_protocol, ahead, exercise};
use crate::compared_shape::TRIANGLE;
use crate::formula::triangle::moeller_trumbore;
use crate::line::{Line, line};
use crate::number::{Triple, difference, dot};

const A: Triple = [0.1, 0.2, 0.3];

/// The directions along and across the needle, of length 1 up to rounding.
const ALONG: Triple = [
    0.267_261_241_912_424_4,
    0.534_522_483_824_848_8,
    0.801_783_725_737_273_2,
];
const ACROSS: Triple = [0.948_683_298_050_513_8, 0.0, -0.316_227_766_016_837_94];

/// Where all rays begin.
const EYE: Triple = [-1.788_044, 4.072_455, -2.112_542];

/// The point of the needle's plane at some lengths along it, and some heights across.
fn place(along: f64, across: f64, aspect: f64) -> Triple {
    [0, 1, 2].map(|axis| A[axis] + ALONG[axis] * along + ACROSS[axis] * (across / aspect))
}

/// The corners of the needle, whose point is at this many heights.
fn needle(height: f64, aspect: f64) -> Vec<f64> {
    [A, place(1.0, 0.0, aspect), place(0.5, height, aspect)].concat()
}

fn towards(target: Triple) -> Line {
    line(EYE, difference(&target, &EYE))
}

/// How many times as long as high a triangle is.
pub const NEEDLE: Sweep = Sweep {
    name: "needle",
    parameter: "length of a triangle, divided by its height",
    computes: "the distance of a point at a third of its height",
    shows: "Two such triangles with a common edge, each drawn as high as wide. Light behind them is white.",
    stage: "a04-intersections",
    powers: [0.0, 16.0],
    harmless: 0.0,
    step: 0.25,
    unit: None,
    exercise: Some(exercise("triangle")),
    at: |aspect| {
        let (needle, line) = (needle(1.0, aspect), towards(place(0.5, 0.33, aspect)));
        let numbers = [&needle[..], &line.origin, &line.direction].concat();
        let ray = line.any_ray();
        let point = Point::of(
            &numbers,
            exact_t,
            against_protocol(&TRIANGLE, &needle, &ray),
        );
        // The formulas get a direction of length 1, so that their `t` is the distance.
        let length = dot(
            &line.direction.map(DoubleDouble::from),
            &line.direction.map(DoubleDouble::from),
        );
        let exact = point.exact * length.sqrt();
        let Line { origin, direction } = Line::of(&ray);
        ahead(Point {
            given: [&needle[..], &origin, &direction].concat(),
            exact,
            size: exact.value(),
            ..point
        })
    },
    picture: |aspect, [x, y]| {
        let ray = towards(place(0.5 + 0.6 * x, 1.2 * y, aspect)).any_ray();
        let [upper, lower] =
            [1.0, -1.0].map(|height| against_protocol(&TRIANGLE, &needle(height, aspect), &ray));
        let seen = |upper: Option<f64>, lower: Option<f64>| match (upper, lower) {
            (Some(_), _) => Some(0.55),
            (None, Some(_)) => Some(0.3),
            (None, None) => None,
        };
        AgainstProtocol {
            ours: seen(upper.ours, lower.ours),
            theirs: seen(upper.theirs, lower.theirs),
        }
    },
};

/// The `t` of three corners, and of a line's origin and direction.
fn exact_t(x: &[DoubleDouble]) -> DoubleDouble {
    let triple = |at: usize| -> Triple<DoubleDouble> { [x[at], x[at + 1], x[at + 2]] };
    let line = Line {
        origin: triple(9),
        direction: triple(12),
    };
    moeller_trumbore(&[triple(0), triple(3), triple(6)], &line).t
}
