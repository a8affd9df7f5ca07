//! `chain`: the lesson's own `Transform`.

use crate::prelude::*;

pub fn chain(steps: &[Step]) -> [Mat4x4; 2] {
    let transform = transform(steps);
    [transform.matrix(), transform.inverse()]
}
