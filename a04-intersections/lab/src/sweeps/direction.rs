//! A direction that is not of length 1.

use measure::extremes::AgainstProtocol;
use measure::sweep::{Point, Sweep};

use super::{UNIT, exercise, hit_of_unit};
use crate::compared_shape::SPHERE;
use crate::line::line;

/// The hit of a ray in this direction down to the unit sphere, as a distance: the protocol's `t` counts lengths
/// of the direction.
fn distances(x: f64, y: f64, length: f64) -> AgainstProtocol<Option<f64>> {
    let down = line([x, y, 3.0], [0.0, 0.0, -length]);
    AgainstProtocol {
        ours: down
            .unit_ray()
            .ok()
            .and_then(|ray| SPHERE.lesson(&UNIT, &ray)),
        theirs: (SPHERE.protocol)(&UNIT, &down.raw_ray()).map(|t| t * length),
    }
}

/// The length of a direction.
pub const DIRECTION: Sweep = Sweep {
    name: "direction",
    parameter: "length of a ray's direction",
    computes: "the distance to a ball of radius 1, two before the ray's origin",
    shows: "The ball by parallel rays with directions of this length.",
    stage: "a04-intersections",
    powers: [-200.0, 200.0],
    harmless: 0.0,
    step: 1.0,
    unit: None,
    exercise: Some(exercise("sphere")),
    at: |length| {
        // The distance is that along a direction of length 1, and so is the condition.
        let mut point = hit_of_unit(line([0.0, 0.0, 3.0], [0.0, 0.0, -1.0]));
        point.given[9] = -length;
        Point {
            factor: length,
            found: distances(0.0, 0.0, length),
            ..point
        }
    },
    picture: |length, [x, y]| {
        let bulge = |distance: f64| 0.25 + 0.75 * (3.0 - distance).clamp(0.0, 1.0);
        distances(1.4 * x, 1.4 * y, length).map(|found| found.map(bulge))
    },
};
