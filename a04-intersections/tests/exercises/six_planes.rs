//! Boxes of six planes anywhere, compared with the solution.

use crate::prelude::*;

yours! { SixPlanes => new_box(SixPlanes::new) }

type Code = NewShape<Corners>;

pub fn exercise() -> Exercise<Code> {
    let eye = Eye {
        from: [2.0, 2.2, 2.9],
        to: [0.05, 0.6, 0.0],
    };
    Exercise {
        picture: shape_picture(([-0.3, 0.1, -0.7], [0.4, 1.2, 0.6]), eye),
        ..shapes()
    }
}
