//! Boards with wide squares, with noise, or without a third dimension.

use a02_math::{Normal3, Point3, Vector3};
use common::Color;
use testing::exercise::Wrong;

use crate::checkerboard::check;
use crate::solutions::checkerboard::checkerboard;

/// White for even numbers.
fn by_turns(is_even: bool) -> Color {
    if is_even { Color::WHITE } else { Color::BLACK }
}

/// The point just below the surface.
fn below(p: Point3, n: Normal3) -> [f64; 3] {
    (p - Vector3::from(n) * 1e-6).to_glam().to_array()
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "a cast, which rounds up below 0",
        says: "in the middle of the cube (-2, -2, -1): expected (0, 0, 0), got (1, 1, 1)",
        check: |c| {
            check(c, |p, n| {
                let number: i64 = below(p, n).map(|x| x as i64).iter().sum();
                by_turns(number.rem_euclid(2) == 0)
            });
        },
    },
    Wrong {
        mistake: "a remainder compared with 1, which is -1 below 0",
        says: "in the middle of the cube (-2, -2, -1): expected (0, 0, 0), got (1, 1, 1)",
        check: |c| {
            check(c, |p, n| {
                by_turns(below(p, n).map(f64::floor).iter().sum::<f64>() % 2.0 != 1.0)
            });
        },
    },
    Wrong {
        mistake: "looked up on the surface, where rounding chooses",
        says: "to the plane x = -3 at [-3, -7.5, -7.5], the face of a cube: expected (1, 1, 1), got (0, 0, 0)",
        check: |c| check(c, |p, _| checkerboard(p, Normal3::new(0.0, 0.0, 0.0))),
    },
    Wrong {
        mistake: "the cube above the surface",
        says: "a ray from [0.3, 5.7, 0.2] to the plane x = -3 at [-3, -7.5, -7.5], the face of a cube: expected (1, 1, 1), got (0, 0, 0)",
        check: |c| check(c, |p, n| checkerboard(p, -n)),
    },
    Wrong {
        mistake: "black and white exchanged",
        says: "in the middle of the cube (-2, -2, -2): expected (1, 1, 1), got (0, 0, 0)",
        check: |c| {
            check(c, |p, n| by_turns(checkerboard(p, n) == Color::BLACK));
        },
    },
    Wrong {
        mistake: "columns without y",
        says: "in the middle of the cube (-2, -1, -2): expected (0, 0, 0), got (1, 1, 1)",
        check: |c| {
            check(c, |p, n| {
                checkerboard(
                    Point3::new(p.x(), 0.5, p.z()),
                    Normal3::new(n.x(), 0.0, n.z()),
                )
            });
        },
    },
    Wrong {
        mistake: "coordinates added before they are rounded",
        says: "in the middle of the cube (-2, -2, -2): expected (1, 1, 1), got (0, 0, 0)",
        check: |c| {
            check(c, |p, n| {
                by_turns(below(p, n).iter().sum::<f64>().floor().rem_euclid(2.0) == 0.0)
            });
        },
    },
    Wrong {
        mistake: "rounded to the nearest",
        says: "in the middle of the cube (-2, -2, 0): expected (1, 1, 1), got (0, 0, 0)",
        check: |c| {
            check(c, |p, n| {
                by_turns(
                    below(p, n)
                        .map(f64::round)
                        .iter()
                        .sum::<f64>()
                        .rem_euclid(2.0)
                        == 0.0,
                )
            });
        },
    },
];
