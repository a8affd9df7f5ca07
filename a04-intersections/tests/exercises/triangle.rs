//! Triangles anywhere, compared with the solution.

use crate::prelude::*;

yours! { Triangle => new_shape(|[a, b, c]: [_; 3]| Triangle::new(point(a), point(b), point(c))) }

/// Makes a triangle by its corners.
type Code = NewShape<[[f64; 3]; 3]>;

pub fn exercise() -> Exercise<Code> {
    let corners = [[-0.5, 0.5, -3.0], [0.5, 0.5, -3.0], [0.5, -0.5, -3.0]];
    Exercise {
        picture: scene("scene-4", scene_4, corners),
        ..shapes()
    }
}
