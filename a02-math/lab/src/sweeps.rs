//! Problems of this stage from harmless to extreme.

use a02_math::Vector3;
use measure::extremes::AgainstProtocol;
use measure::sweep::{Exercise, Point, Sweep, arc_tangent};

use crate::protocol;

/// The angle between two vectors.
pub const ANGLE: Sweep = Sweep {
    name: "angle",
    parameter: "tangent of the angle between two vectors",
    computes: "the angle between (1, 0, 0) and (1, t, 0), in radians",
    shows: "A target around the first vector: each ring is a fifth of the angle wide.",
    stage: "a02-math",
    powers: [0.0, -16.0],
    harmless: 0.0,
    step: 0.25,
    unit: None,
    exercise: Some(Exercise {
        name: "angle",
        part: "",
    }),
    at: |t| {
        let given = [1.0, 0.0, 0.0, 1.0, t, 0.0];
        let found = angles(Vector3::new(1.0, t, 0.0)).map(Some);
        Point::of(&given, |x| arc_tangent(x[4] / x[3]), found)
    },
    picture: |t, [x, y]| {
        let angles = angles(Vector3::new(1.0, t * x, t * y));
        let is_bright = |angle: f64| ((angle / t * 5.0) as u32).is_multiple_of(2);
        angles.map(|angle| Some(if is_bright(angle) { 0.9 } else { 0.4 }))
    },
};

/// The angle to (1, 0, 0), by the lesson and by the protocol.
fn angles(v: Vector3) -> AgainstProtocol<f64> {
    let axis = Vector3::new(1.0, 0.0, 0.0);
    AgainstProtocol {
        ours: axis.angle(v),
        theirs: protocol::angle_by_arc_cosine(axis, v),
    }
}
