//! A ball of radius 1 that goes away.

use measure::sweep::Sweep;

use super::{UNIT, against_protocol, exercise, hit_of_unit};
use crate::compared_shape::SPHERE;
use crate::line::{Line, line};

/// The distance of a ball.
pub const FAR_BALL: Sweep = Sweep {
    name: "distance",
    parameter: "distance of a ball of radius 1",
    computes: "the t at which a ray half a radius beside its middle hits it",
    shows: "The ball by parallel rays from there: the farther its surface bulges, the brighter it is.",
    stage: "a04-intersections",
    powers: [0.5, 14.0],
    harmless: 0.5,
    step: 0.25,
    unit: Some("radii"),
    exercise: Some(exercise("sphere")),
    at: |distance| hit_of_unit(ray_from(distance, [0.5, 0.0])),
    picture: |distance, [x, y]| {
        let from = ray_from(distance, [1.4 * x, 1.4 * y]);
        let bulge = |t: f64| 0.25 + 0.75 * (distance - t).clamp(0.0, 1.0);
        against_protocol(&SPHERE, &UNIT, &from.raw_ray()).map(|found| found.map(bulge))
    },
};

/// Three perpendicular directions, along none of which a coordinate is 0: on a ray along an axis b² and 4ac round
/// alike, and their difference is right for longer than that of other rays.
const BACK: [f64; 3] = [2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0];
const RIGHT: [f64; 3] = [3.0 / 7.0, -6.0 / 7.0, 2.0 / 7.0];
const UP: [f64; 3] = [6.0 / 7.0, 2.0 / 7.0, -3.0 / 7.0];

/// The ray from a distance that passes the middle at a place to the right and upwards.
fn ray_from(distance: f64, [right, up]: [f64; 2]) -> Line {
    let origin = |i: usize| BACK[i] * distance + RIGHT[i] * right + UP[i] * up;
    line([0, 1, 2].map(origin), BACK.map(|x| -x))
}
