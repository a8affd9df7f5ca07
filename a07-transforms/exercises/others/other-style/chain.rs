//! `chain` as the first step around the chain of all others.

use crate::prelude::*;

pub fn chain(steps: &[Step]) -> [Mat4x4; 2] {
    let Some((first, others)) = steps.split_first() else {
        return [Mat4x4::IDENTITY; 2];
    };
    let [matrix, inverse] = chain(others);
    [first.matrix() * matrix, inverse * first.inverse()]
}
