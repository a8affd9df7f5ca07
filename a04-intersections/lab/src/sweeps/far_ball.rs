//! A ball of radius 1 that goes away.

use measure::sweep::Sweep;

use super::{UNIT, against_protocol, exercise, hit_of_unit};
use crate::compared_shape::SPHERE;
use crate::line::line;

/// The distance of a ball.
pub const FAR_BALL: Sweep = Sweep {
    name: "distance",
    parameter: "distance of a ball of radius 1",
    computes: "the t at which a ray half a radius beside its middle hits it",
    shows: "The ball by parallel rays from there: the farther its surface bulges, the brighter it is.",
    stage: "a04-intersections",
    powers: [0.5, 16.0],
    harmless: 0.5,
    step: 0.25,
    unit: Some("radii"),
    exercise: Some(exercise("sphere")),
    at: |distance| hit_of_unit(line([0.5, 0.0, distance], [0.0, 0.0, -1.0])),
    picture: |distance, [x, y]| {
        let from = line([1.4 * x, 1.4 * y, distance], [0.0, 0.0, -1.0]);
        let bulge = |t: f64| 0.25 + 0.75 * (distance - t).clamp(0.0, 1.0);
        against_protocol(&SPHERE, &UNIT, &from.raw_ray()).map(|found| found.map(bulge))
    },
};
