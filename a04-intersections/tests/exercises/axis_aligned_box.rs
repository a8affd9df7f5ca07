//! Boxes anywhere, compared with the solution.

use crate::prelude::*;

yours! { AxisAlignedBox => new_box(AxisAlignedBox::new) }

type Code = NewShape<Corners>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: scene("scene-3", scene_3, ([-0.5, 0.0, -0.5], [0.5, 1.0, 0.5])),
        ..shapes()
    }
}
