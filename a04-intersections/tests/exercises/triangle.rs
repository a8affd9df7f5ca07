//! Triangles anywhere, compared with the solution.

use crate::prelude::*;

yours! { Triangle => new_shape(|[a, b, c]: [_; 3]| Triangle::new(point(a), point(b), point(c))) }

/// Makes a triangle by its corners.
type Code = NewShape<[[f64; 3]; 3]>;

const FIRST: [[f64; 3]; 3] = [[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [0.0, 2.0, 1.0]];
const TINY: [[f64; 3]; 3] = [[-UNIT, -UNIT, 0.0], [UNIT, -UNIT, 0.0], [0.0, UNIT, 0.0]];
const UNIT: f64 = 1.0 / 1_073_741_824.0;
const DOWN: [f64; 3] = [0.0, 0.0, -1.0];

pub fn exercise() -> Exercise<Code> {
    let corners = [[-0.5, 0.5, -3.0], [0.5, 0.5, -3.0], [0.5, -0.5, -3.0]];
    Exercise {
        picture: scene("scene-4", scene_4, corners),
        ..shapes(Shapes {
            words: "triangle {}",
            first: FIRST,
            further: vec![
                // In the planes of two axes, and beside them.
                [[0.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]],
                [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, 2.0]],
                [[1.0, -2.0, -2.0], [1.0, 0.0, 2.0], [1.0, 2.0, -2.0]],
                [[-2.0, -1.0, -2.0], [2.0, -1.0, -2.0], [0.0, -1.0, 2.0]],
            ],
            on_surface: vec![[0.5, 0.5, 1.0], [0.0, 0.0, 1.0], [1.0, 0.0, 1.0]],
            own_rays: [
                // An epsilon is greater than its determinant.
                vec![(TINY, ahead([0.0, 0.0, 4.0], DOWN))],
                of_sizes(|size| FIRST.map(|corner| corner.map(|x| x * size))),
                beside(
                    &FIRST,
                    &[
                        ([0.5, 0.0, 1.0], DOWN, [0.0, -1.0, 0.0]),
                        ([0.0, 0.5, 1.0], DOWN, [-1.0, 0.0, 0.0]),
                        ([1.0, 1.0, 1.0], DOWN, [1.0, 1.0, 0.0]),
                        ([2.0, 0.0, 1.0], DOWN, [1.0, 0.0, 0.0]),
                    ],
                ),
            ]
            .concat(),
            middle: |[a, b, c]| [0, 1, 2].map(|k| (a[k] + b[k] + c[k]) / 3.0),
            any: |r| [(); 3].map(|()| r.triple(5.0)),
        })
    }
}
