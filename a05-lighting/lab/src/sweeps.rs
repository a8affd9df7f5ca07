//! A problem of this stage from harmless to extreme.

use a02_math::{Point3, Vector3};
use common::Color;
use measure::extremes::AgainstProtocol;
use measure::sweep::{Point, Sweep, tangent};

use crate::protocol;
use a05_lighting::{Light, SpotLight};

/// Along the axis of the spot light, at the origin.
const AXIS: Vector3 = Vector3::new(0.0, 0.0, -1.0);

/// Whether the light of a cone falls on a place of a wall at the distance 1.
fn is_lit(half_angle: f64, x: f64, y: f64) -> AgainstProtocol<Option<bool>> {
    let place = Point3::new(x, y, -1.0);
    let spot = SpotLight::new(Color::WHITE, Point3::ORIGIN, AXIS, half_angle);
    let theirs = protocol::spot_light_illuminates(Point3::ORIGIN, AXIS, half_angle, place);
    AgainstProtocol {
        ours: spot.ok().map(|spot| spot.illuminates(place)),
        theirs: Some(theirs),
    }
}

/// The greatest x that is lit, by halving an interval until its ends are neighbours.
pub fn edge(half_angle: f64) -> AgainstProtocol<Option<f64>> {
    let search = |is_lit: &dyn Fn(f64) -> Option<bool>| {
        let (mut lit, mut dark) = (0.0, 1e6);
        while lit < f64::midpoint(lit, dark) && f64::midpoint(lit, dark) < dark {
            let middle = f64::midpoint(lit, dark);
            if is_lit(middle)? {
                lit = middle;
            } else {
                dark = middle;
            }
        }
        Some(lit)
    };
    AgainstProtocol {
        ours: search(&|x| is_lit(half_angle, x, 0.0).ours),
        theirs: search(&|x| is_lit(half_angle, x, 0.0).theirs),
    }
}

/// The half angle of a spot light.
pub const SPOT: Sweep = Sweep {
    name: "spot",
    parameter: "half angle of a spot light, in radians",
    computes: "the radius of its light on a wall at the distance 1",
    shows: "The light on the wall, enlarged until it should fill five eighths of the width.",
    stage: "a05-lighting",
    powers: [0.0, -10.0],
    harmless: 0.0,
    step: 0.25,
    unit: None,
    exercise: None,
    at: |half_angle| Point::of(&[half_angle], |x| tangent(x[0]), edge(half_angle)),
    picture: |half_angle, place| {
        let [x, y] = place.map(|x| x * 1.6 * libm::tan(half_angle));
        is_lit(half_angle, x, y).map(|lit| lit.filter(|lit| *lit).map(|_| 0.9))
    },
};
