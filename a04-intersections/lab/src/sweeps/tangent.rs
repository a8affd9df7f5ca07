//! A ray that comes nearer and nearer to a sphere's tangent.

use measure::sweep::Sweep;

use super::{UNIT, against_protocol, exercise, hit_of_unit};
use crate::compared_shape::SPHERE;
use crate::line::line;

/// How far below the tangent of a ball a ray passes.
pub const TANGENT: Sweep = Sweep {
    name: "tangent",
    parameter: "distance of a ray below the tangent of a ball of radius 1",
    computes: "the t at which the ray from 5 before its middle hits it",
    shows: "The highest point of the ball, enlarged until this distance is a quarter of the picture's height.",
    stage: "a04-intersections",
    powers: [0.0, -16.0],
    harmless: 0.0,
    step: 0.25,
    unit: None,
    exercise: Some(exercise("sphere")),
    at: |below| hit_of_unit(line([-5.0, 1.0 - below, 0.0], [1.0, 0.0, 0.0])),
    picture: |below, [x, y]| {
        let height = 1.0 + below * (2.0 * y - 1.0);
        let past = line(
            [-5.0, height, x * (2.0 * below).sqrt() * 1.2],
            [1.0, 0.0, 0.0],
        );
        let deepest = (6.0 * below).sqrt();
        let depth = |t: f64| 0.3 + 0.7 * ((5.0 - t) / deepest).clamp(0.0, 1.0);
        against_protocol(&SPHERE, &UNIT, &past.raw_ray()).map(|found| found.map(depth))
    },
};
