//! Tori of many sizes, compared with the solution.

use crate::prelude::*;

yours! { Torus => new_shape(|(ring, r)| Torus::new(ring, r)) }

/// Makes a torus of the radii of its circle and its tube.
type Code = NewShape<(f64, f64)>;

pub fn exercise() -> Exercise<Code> {
    let eye = Eye {
        from: [2.0, 5.0, 7.0],
        to: [0.0, -0.2, 0.0],
    };
    Exercise {
        picture: shown((2.0, 0.5), eye),
        ..shapes(Shapes {
            words: "circle of radius {}, tube of radius {}",
            // No simple ray just touches it: a right march may pass over that point.
            first: (2.0, 0.75),
            further: vec![],
            on_surface: vec![],
            own_rays: of_sizes(|size| (2.0 * size, 0.75 * size)),
            middle: |(ring, _)| [*ring, 0.0, 0.0],
            any: |r| (r.between(2.0, 5.0), r.between(0.5, 1.5)),
        })
    }
}
