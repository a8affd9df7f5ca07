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
        picture: shape_picture((2.0, 0.5), eye),
        ..shapes()
    }
}
