//! The lesson's chain, until yours is done: `cargo learn chain`. Then copy your file here, without
//! the examples at its end.

use crate::prelude::*;

pub fn chain(steps: &[Step]) -> [Mat4x4; 2] {
    let mut transform = a07_transforms::Transform::IDENTITY;
    for step in steps {
        transform = step.after(transform);
    }
    [transform.matrix(), transform.inverse()]
}
