//! Lengths that leave the range of numbers, or a coordinate behind.

use testing::exercise::Wrong;

use crate::length::check;

fn plain(x: f64, y: f64, z: f64) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

/// Divided by this scale, and multiplied with it again.
fn scaled(x: f64, y: f64, z: f64, scale: f64) -> f64 {
    scale * plain(x / scale, y / scale, z / scale)
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "squares that overflow",
        says: "the length of (3e155, 4e155, 0e0): expected 5e155, got inf",
        check: |c| check(c, plain),
    },
    Wrong {
        mistake: "divided by 0 for the zero vector",
        says: "the length of (0e0, 0e0, 0e0): expected 0, got NaN",
        check: |c| {
            check(c, |x, y, z| {
                scaled(x, y, z, x.abs().max(y.abs()).max(z.abs()))
            });
        },
    },
    Wrong {
        mistake: "the largest coordinate without abs",
        says: "the length of (0e0, 0e0, -2e0): expected 2, got 0",
        check: |c| {
            check(c, |x, y, z| {
                let largest = x.max(y).max(z);
                if largest == 0.0 {
                    0.0
                } else {
                    scaled(x, y, z, largest)
                }
            });
        },
    },
    Wrong {
        mistake: "divided by x, whether it is the largest or not",
        says: "the length of (0e0, 0e0, -2e0): expected 2, got NaN",
        check: |c| check(c, |x, y, z| scaled(x, y, z, x.abs())),
    },
    Wrong {
        mistake: "not multiplied with the largest at the end",
        says: "the length of (3e0, 4e0, 0e0): expected 5, got 1.25",
        check: |c| {
            check(c, |x, y, z| {
                let largest = x.abs().max(y.abs()).max(z.abs());
                if largest == 0.0 {
                    0.0
                } else {
                    plain(x / largest, y / largest, z / largest)
                }
            });
        },
    },
    Wrong {
        mistake: "without z",
        says: "the length of (2e0, 3e0, 6e0): expected 7, got 3.6",
        check: |c| check(c, |x, y, _| libm::hypot(x, y)),
    },
    Wrong {
        mistake: "the sum of the coordinates",
        says: "the length of (3e0, 4e0, 0e0): expected 5, got 7",
        check: |c| check(c, |x, y, z| x.abs() + y.abs() + z.abs()),
    },
];
