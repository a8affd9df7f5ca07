//! Planes anywhere, compared with the solution.

use crate::prelude::*;

yours! { Plane => new_shape(|(a, n)| Plane::new(point(a), vector(n).as_normal())) }

/// Makes a plane by a point and a normal.
type Code = NewShape<([f64; 3], [f64; 3])>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: scene("scene-1", scene_1, ([0.0, -1.0, 0.0], [0.0, 1.0, 0.0])),
        ..shapes()
    }
}
