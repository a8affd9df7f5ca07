//! Triangles anywhere, compared with the solution.

use crate::prelude::*;

yours! { Triangle => new_shape(|[a, b, c]: [_; 3]| Triangle::new(point(a), point(b), point(c))) }

/// Makes a triangle by its corners.
type Code = NewShape<[[f64; 3]; 3]>;

const TINY: f64 = 1.0 / 1_073_741_824.0;

pub fn exercise() -> Exercise<Code> {
    let corners = [[-0.5, 0.5, -3.0], [0.5, 0.5, -3.0], [0.5, -0.5, -3.0]];
    Exercise {
        picture: scene("scene-4", scene_4, corners),
        ..shapes(Shapes {
            words: "triangle {}",
            first: [[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [0.0, 2.0, 1.0]],
            further: vec![
                [[-TINY, -TINY, 0.0], [TINY, -TINY, 0.0], [0.0, TINY, 0.0]],
                // In the planes of two axes, and beside them.
                [[0.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]],
                [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, 2.0]],
                [[1.0, -2.0, -2.0], [1.0, 0.0, 2.0], [1.0, 2.0, -2.0]],
                [[-2.0, -1.0, -2.0], [2.0, -1.0, -2.0], [0.0, -1.0, 2.0]],
            ],
            on_surface: vec![[0.5, 0.5, 1.0], [0.0, 0.0, 1.0], [1.0, 0.0, 1.0]],
            own_rays: vec![],
            middle: |[a, b, c]| [0, 1, 2].map(|k| (a[k] + b[k] + c[k]) / 3.0),
            any: |r| [(); 3].map(|()| r.triple(5.0)),
        })
    }
}
