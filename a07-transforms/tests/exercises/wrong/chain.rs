//! Wrong solutions: other orders.

use a07_transforms::Mat4x4;
use testing::exercise::Wrong;

use crate::chain;
use crate::steps::Step;

fn product(matrices: impl Iterator<Item = Mat4x4>) -> Mat4x4 {
    matrices.fold(Mat4x4::IDENTITY, |product, matrix| product * matrix)
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the first step is applied first",
        says: "the matrix times a point, two steps",
        check: |c| {
            chain::check(c, |steps| {
                let forwards = steps.iter().map(|step| step.inverse());
                let backwards = steps.iter().rev().map(|step| step.matrix());
                [product(backwards), product(forwards)]
            });
        },
    },
    Wrong {
        mistake: "the inverses in the same order as the matrices",
        says: "the inverse times the moved point, two steps",
        check: |c| {
            chain::check(c, |steps| {
                [
                    product(steps.iter().map(|s| s.matrix())),
                    product(steps.iter().map(|s| s.inverse())),
                ]
            });
        },
    },
    Wrong {
        mistake: "the transposed matrix as inverse",
        says: "the inverse times the moved point, one step",
        check: |c| {
            chain::check(c, |steps| {
                let matrix = product(steps.iter().map(|step| step.matrix()));
                [matrix, matrix.transposed()]
            });
        },
    },
    Wrong {
        mistake: "only the last step",
        says: "two steps",
        check: |c| {
            chain::check(c, |steps| {
                let last =
                    |f: fn(Step) -> Mat4x4| steps.last().map_or(Mat4x4::IDENTITY, |step| f(*step));
                [last(Step::matrix), last(Step::inverse)]
            });
        },
    },
];
