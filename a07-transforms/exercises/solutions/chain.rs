//! `chain`: the lesson's own `Transform`.

use a07_transforms::{Mat4x4, Transform};

pub use crate::steps::Step;

pub fn chain(steps: &[Step]) -> [Mat4x4; 2] {
    let transform = steps
        .iter()
        .fold(Transform::IDENTITY, |t, step| step.after(t));
    [transform.matrix(), transform.inverse()]
}
