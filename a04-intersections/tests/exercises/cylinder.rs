//! Tubes of many sizes, compared with the solution.

use crate::prelude::*;

yours! { Cylinder => new_shape(|(r, height)| Cylinder::new(r, height)) }

/// Makes a tube of a radius and a height.
type Code = NewShape<(f64, f64)>;

pub fn exercise() -> Exercise<Code> {
    let eye = Eye {
        from: [1.5, 4.5, 4.5],
        to: [0.0, 0.9, 0.0],
    };
    Exercise {
        picture: shown((1.0, 2.0), eye),
        ..shapes(Shapes {
            words: "tube of radius {} and height {}",
            first: (1.0, 2.0),
            further: vec![(2.0, 0.5)],
            on_surface: vec![[1.0, 1.0, 0.0], [0.0, 0.5, -1.0], [0.0, 2.0, 1.0]],
            own_rays: [
                of_sizes(|size| (size, 2.0 * size)),
                beside(
                    &(1.0, 2.0),
                    &[
                        ([0.0, 2.0, 1.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]),
                        ([0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.0, -1.0, 0.0]),
                    ],
                ),
            ]
            .concat(),
            middle: |(_, height)| [0.0, height / 2.0, 0.0],
            any: |r| (r.between(0.1, 5.0), r.between(0.1, 9.0)),
        })
    }
}
