//! Spheres anywhere, compared with the solution.

use crate::prelude::*;

yours! { Sphere => new_shape(|(c, r)| Sphere::new(point(c), r)) }

type Code = NewShape<([f64; 3], f64)>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: scene("scene-2", scene_2, ([0.0, 0.0, -3.0], 0.5)),
        ..shapes()
    }
}
