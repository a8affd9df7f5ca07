//! `chain`: the matrix of several steps, and its inverse.

use crate::prelude::*;

/// The matrix of a chain of steps from the space of the object to the space around it, and
/// its inverse. The last step is applied to the object first.
///
/// `step.matrix()` is the matrix of one step, and `step.inverse()` undoes it. `a * b` is
/// the product of matrices, which applies b first, and `Mat4x4::IDENTITY` changes nothing.
pub fn chain(steps: &[Step]) -> [Mat4x4; 2] {
    // 1. Multiply the matrices so that the last step is applied first.
    // 2. Multiply the inverses so that the steps are undone in the reverse order.
    missing!("the two products", [Mat4x4::IDENTITY; 2], {
        let mut matrix = Mat4x4::IDENTITY;
        let mut inverse = Mat4x4::IDENTITY;
        for step in steps {
            matrix = matrix * step.matrix();
            inverse = step.inverse() * inverse;
        }
        [matrix, inverse]
    })
}

testing::examples! {
    let step = Step::Translate([2.0, 0.0, 0.0]);
    let double = Step::Scale([2.0, 2.0, 2.0]);
    let moved = |steps: &[Step], x| {
        chain(steps).map(|matrix| (matrix * Point3::new(x, 0.0, 0.0)).x())
    };
    assert_close!(moved(&[], 1.0), [1.0, 1.0], "no step");
    assert_close!(moved(&[step], 1.0), [3.0, -1.0], "one step, and back");
    assert_close!(moved(&[step, double], 1.0), [4.0, -0.5], "the last step first");
    assert_close!(moved(&[double, step], 1.0), [6.0, -1.5]);
}
