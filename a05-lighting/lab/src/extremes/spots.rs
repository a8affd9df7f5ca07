//! Counts over many spot lights and angles.

use a02_lab::protocol::angle_by_arc_cosine;
use a02_math::arrays::{point, vector};
use a02_math::{Point3, Vector3};
use a04_lab::support::{Numbers, Triple};
use common::Color;
use measure::extremes::{Case, Flag};

use crate::protocol;
use a05_lighting::{Light, SpotLight};

/// Whether a spot light at the origin, unchecked, shines on a point.
pub fn lights(direction: Triple, half_angle: f64, at: Triple) -> Case {
    let (direction, at) = (vector(direction), point(at));
    let ours = SpotLight::new(Color::WHITE, Point3::ORIGIN, direction, half_angle);
    let ours = ours.map(|light| light.illuminates(at));
    let theirs = protocol::spot_light_illuminates(Point3::ORIGIN, direction, half_angle, at);
    Case::of(ours, theirs)
}

/// Random directions of any length below √3.
fn directions(count: usize) -> Vec<Vector3> {
    (0..count)
        .map(|i| Numbers::new(9, i).triple(-1.0, 1.0))
        .collect()
}

/// The number of lights that shine on a point straight behind them.
pub fn lit_behind(count: usize) -> Case {
    let (mut ours, mut theirs) = (0, 0);
    for direction in directions(count) {
        let behind = Point3::ORIGIN - direction * 3.0;
        let case = lights(direction.into(), 0.1, behind.into());
        ours += usize::from(case.ours == Flag(true));
        theirs += usize::from(case.theirs == Some(Flag(true)));
    }
    Case::of(ours, theirs)
}

/// The number of angles between parallel vectors that are NaN.
pub fn angles(count: usize) -> Case {
    let directions = directions(count);
    Case::of(
        not_numbers(&directions, Vector3::angle),
        not_numbers(&directions, angle_by_arc_cosine),
    )
}

/// The number of vectors whose angle to a multiple of themselves is NaN.
fn not_numbers(vectors: &[Vector3], angle: fn(Vector3, Vector3) -> f64) -> usize {
    let angles = vectors.iter().map(|v| angle(*v, *v * 3.0));
    angles.filter(|angle| angle.is_nan()).count()
}
