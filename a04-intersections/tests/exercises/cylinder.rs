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
        picture: shape_picture((1.0, 2.0), eye),
        ..shapes()
    }
}
