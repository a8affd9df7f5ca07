//! `chain`: the matrix of several steps, and its inverse.

use crate::prelude::*;

/// The matrix of a chain of steps from the space of the object to the space around it, and
/// its inverse. The last step is applied to the object first.
///
/// `step.matrix()` is the matrix of one step, and `step.inverse()` undoes it. `a * b` is
/// the product of matrices, which applies b first, and `Mat4x4::IDENTITY` changes nothing.
pub fn chain(steps: &[Step]) -> [Mat4x4; 2] {
    let mut matrix = Mat4x4::IDENTITY;
    let mut inverse = Mat4x4::IDENTITY;
    for step in steps {
        matrix = matrix * step.matrix();
        inverse = step.inverse() * inverse;
    }
    [matrix, inverse]
}
