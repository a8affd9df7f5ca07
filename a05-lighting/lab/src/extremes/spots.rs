//! Spot lights: points at the rim, on the axis and behind; and angles between vectors.

use std::f64::consts::PI;

use a02_lab::condition::condition_of_angle;
use a02_lab::protocol::angle_by_arc_cosine;
use a02_math::arrays::{array, point, vector};
use a02_math::{Point3, Vector3};
use a04_lab::support::{Numbers, Triple};
use common::Color;
use measure::Effort;
use measure::extremes::{Case, Fails, Flag, Holds, Known, Number, Refused, Ulps};

use crate::protocol;
use a05_lighting::{Light, SpotLight};

/// A spot light at the origin, unchecked.
#[derive(Clone, Copy)]
struct Spot {
    direction: Triple,
    half_angle: f64,
}

const ONES: Triple = [1.0; 3];
const AHEAD: Triple = [0.0, 0.0, -1.0];

/// The light along -z.
const fn ahead(half_angle: f64) -> Spot {
    Spot {
        direction: AHEAD,
        half_angle,
    }
}

/// The light along (1, 1, 1).
const ALONG_ONES: Spot = Spot {
    direction: ONES,
    half_angle: 0.1,
};

impl Spot {
    /// Whether it shines on a point.
    fn lights(self, at: Triple) -> Case {
        let (direction, half_angle, at) = (vector(self.direction), self.half_angle, point(at));
        let ours = SpotLight::new(Color::WHITE, Point3::ORIGIN, direction, half_angle);
        let ours = ours.map(|light| light.illuminates(at));
        let theirs = protocol::spot_light_illuminates(Point3::ORIGIN, direction, half_angle, at);
        Case::of(ours, theirs)
    }
}

/// The point at an angle beside the direction -z.
fn beside(angle: f64) -> Triple {
    [libm::sin(angle), 0.0, -libm::cos(angle)]
}

pub fn cases(effort: Effort) -> Vec<Case> {
    let count = effort.choose(10_000, 100_000);
    let directions = directions(count);
    let (x, diagonal) = (Vector3::new(2.0, 0.0, 0.0), Vector3::new(1.0, 1.0, 0.0));
    let mut cases = points();
    cases.push(Case {
        id: "I09",
        what: format!("spot, {count} points straight behind: lit"),
        exact: Number(0.0),
        protocol: Fails,
        ..lit_behind(&directions)
    });
    cases.push(Case {
        id: "S15",
        what: format!("{count} angles between parallel vectors: NaN"),
        exact: Number(0.0),
        protocol: Fails,
        ..Case::of(
            not_numbers(&directions, Vector3::angle),
            not_numbers(&directions, angle_by_arc_cosine),
        )
    });
    cases.push(Case {
        id: "F39",
        what: "angle between (2, 0, 0) and (1, 1, 0)".into(),
        exact: Number(PI / 4.0),
        condition: Known(condition_of_angle(array(x), array(diagonal), PI / 4.0)),
        bound: Ulps(1.0),
        protocol: Fails,
        ..Case::of(x.angle(diagonal), protocol::angle(x, diagonal))
    });
    cases
}

/// Random directions of any length below √3.
fn directions(count: usize) -> Vec<Vector3> {
    (0..count)
        .map(|i| Numbers::new(9, i).triple(-1.0, 1.0))
        .collect()
}

/// The number of lights that shine on a point straight behind them.
fn lit_behind(directions: &[Vector3]) -> Case {
    let (mut ours, mut theirs) = (0, 0);
    for direction in directions {
        let spot = Spot {
            direction: (*direction).into(),
            half_angle: 0.1,
        };
        let behind = Point3::ORIGIN - *direction * 3.0;
        let case = spot.lights(behind.into());
        ours += usize::from(case.ours == Flag(true));
        theirs += usize::from(case.theirs == Some(Flag(true)));
    }
    Case::of(ours, theirs)
}

/// The number of vectors whose angle to a multiple of themselves is NaN.
fn not_numbers(vectors: &[Vector3], angle: fn(Vector3, Vector3) -> f64) -> usize {
    let angles = vectors.iter().map(|v| angle(*v, *v * 3.0));
    angles.filter(|angle| angle.is_nan()).count()
}

/// Whether a light shines on a point.
fn points() -> Vec<Case> {
    let without_angle = Spot {
        direction: [1.0, 1.0, 8.0],
        half_angle: 0.0,
    };
    vec![
        Case {
            id: "F06",
            what: "spot, a point on the axis: lit".into(),
            exact: Flag(true),
            protocol: Holds,
            ..ALONG_ONES.lights(ONES)
        },
        Case {
            id: "F07",
            what: "spot, a point straight behind: lit".into(),
            exact: Flag(false),
            protocol: Fails,
            ..ALONG_ONES.lights([-1.0; 3])
        },
        Case {
            id: "F08",
            what: "spot, half angle 0, a point on the axis: lit".into(),
            exact: Refused,
            protocol: Fails,
            ..without_angle.lights(without_angle.direction)
        },
        Case {
            id: "F09",
            what: "spot, half angle π, a point straight behind: lit".into(),
            exact: Flag(true),
            protocol: Holds,
            ..ahead(PI).lights([0.0, 0.0, 1.0])
        },
        Case {
            id: "F10",
            what: "spot, half angle 1e-9, a point at 1e-8: lit".into(),
            exact: Refused,
            protocol: Fails,
            ..ahead(1e-9).lights(beside(1e-8))
        },
        Case {
            id: "F11",
            what: "spot, the position itself: lit".into(),
            exact: Flag(false),
            protocol: Fails,
            ..ahead(0.1).lights([0.0; 3])
        },
        Case {
            id: "F12",
            what: "spot, half angle NaN: lit".into(),
            exact: Refused,
            protocol: Fails,
            ..ahead(f64::NAN).lights(AHEAD)
        },
        Case {
            id: "F13",
            what: "spot, a point 1e200 away on the axis: lit".into(),
            exact: Flag(true),
            protocol: Fails,
            ..ahead(0.1).lights([0.0, 0.0, -1e200])
        },
        Case {
            id: "F37",
            what: "spot, half angle 1e-7, a point at 1.2e-7: lit".into(),
            exact: Flag(false),
            protocol: Holds,
            ..ahead(1e-7).lights(beside(1.2e-7))
        },
        Case {
            id: "F38",
            what: "spot, half angle 1e-7, a point at 0.8e-7: lit".into(),
            exact: Flag(true),
            protocol: Holds,
            ..ahead(1e-7).lights(beside(0.8e-7))
        },
    ]
}
