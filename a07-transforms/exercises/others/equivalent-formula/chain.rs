//! `chain` from the last step to the first.

use crate::prelude::*;

pub fn chain(steps: &[Step]) -> [Mat4x4; 2] {
    let mut products = [Mat4x4::IDENTITY; 2];
    for step in steps.iter().rev() {
        products = [step.matrix() * products[0], products[1] * step.inverse()];
    }
    products
}
