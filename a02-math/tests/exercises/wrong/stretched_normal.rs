//! Normals that are stretched like a way, or not made unit.

use a02_math::Normal3;
use testing::exercise::Wrong;

use crate::solutions::stretched_normal::stretched_normal;
use crate::stretched_normal::check;

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "multiplied, as a vector is",
        says: "[0.6, 0.8, 0.0], stretched by [0.75, 1.3333333333333333, 9.0]: expected (0.8",
        check: |c| {
            check(c, |n, factors| {
                stretched_normal(n, factors.map(|factor| 1.0 / factor))
            });
        },
    },
    Wrong {
        mistake: "not made unit",
        says: "[0.6, 0.8, 0.0], stretched by [5.0, 5.0, 5.0]: expected (0.6, 0.8, 0), got (0.12,",
        check: |c| {
            check(c, |n, [x, y, z]| {
                stretched_normal(n, [x, y, z])?;
                Some(Normal3::new(n.x() / x, n.y() / y, n.z() / z))
            });
        },
    },
    Wrong {
        mistake: "without the sign of a factor",
        says: "[0.6, 0.8, 0.0], stretched by [-1.0, 1.0, 1.0]: expected (-0.6, 0.8, 0), got (0.6",
        check: |c| check(c, |n, factors| stretched_normal(n, factors.map(f64::abs))),
    },
    Wrong {
        mistake: "divided by the squares",
        says: "[0.6, 0.8, 0.0], stretched by [0.75, 1.3333333333333333, 9.0]: expected (0.8",
        check: |c| {
            check(c, |n, factors| {
                stretched_normal(n, factors.map(|f| f * f.abs()))
            });
        },
    },
    Wrong {
        mistake: "the factor 0 passed over",
        says: "[0.6, 0.8, 0.0], stretched by [0.0, 1.0, 1.0]: expected none, got (0.6",
        check: |c| {
            check(c, |n, factors| {
                stretched_normal(n, factors.map(|f| if f == 0.0 { 1.0 } else { f }))
            });
        },
    },
    Wrong {
        mistake: "only the factor along x compared with 0",
        says: "stretched by [1.0, 1.0, 0.0]: expected none, got",
        check: |c| {
            check(c, |n, [x, y, z]| {
                let tiny = |factor: f64| if factor == 0.0 { 1e-9 } else { factor };
                stretched_normal(n, [x, tiny(y), tiny(z)])
            });
        },
    },
    Wrong {
        mistake: "a normal for the zero normal",
        says: "[0.0, 0.0, 0.0], stretched by [1.0, 2.0, 3.0]: expected none, got (NaN",
        check: |c| {
            check(c, |n, factors| {
                let nothing = Normal3::new(f64::NAN, f64::NAN, f64::NAN);
                let is_zero = n == Normal3::new(0.0, 0.0, 0.0);
                if is_zero {
                    Some(nothing)
                } else {
                    stretched_normal(n, factors)
                }
            });
        },
    },
    Wrong {
        mistake: "turned to the side of the old normal",
        says: "[0.6, 0.0, 0.8], stretched by [1.0, 1.0, -1.0]: expected (0.6, 0, -0.8), got (-0.6",
        check: |c| {
            check(c, |n, factors| {
                let new = stretched_normal(n, factors)?;
                let before = a02_math::Vector3::from(n);
                let after = a02_math::Vector3::from(new);
                Some(if a02_math::Direction::dot(before, after) < 0.0 {
                    -new
                } else {
                    new
                })
            });
        },
    },
];
