//! Digits in a wrong order, at a wrong place, or in one base only.

use testing::exercise::Wrong;

use crate::radical_inverse::check;
use crate::solutions::radical_inverse::radical_inverse;

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "digits not mirrored",
        says: "6 in base 2: expected 0.375, got 0.75",
        check: |c| {
            check(c, |n, base| {
                let mut scale = 1.0;
                while f64::from(n) >= scale {
                    scale *= f64::from(base);
                }
                f64::from(n) / scale
            });
        },
    },
    Wrong {
        mistake: "always base 2",
        says: "2 in base 3: expected 0.6666666666666666, got 0.25",
        check: |c| check(c, |n, _| radical_inverse(n, 2)),
    },
    Wrong {
        mistake: "one place too far to the left",
        says: "1 in base 2: expected 0.5, got 1",
        check: |c| check(c, |n, base| radical_inverse(n, base) * f64::from(base)),
    },
    Wrong {
        mistake: "a division of whole numbers",
        says: "1 in base 2: expected 0.5, got 0",
        check: |c| check(c, |n, base| radical_inverse(n, base).floor()),
    },
    Wrong {
        mistake: "the last digit lost",
        says: "1 in base 2: expected 0.5, got 0",
        check: |c| {
            check(c, |n, base| {
                radical_inverse(n / base, base) / f64::from(base)
            });
        },
    },
    Wrong {
        mistake: "places counted in base 2, digits in the given base",
        says: "1 in base 3: expected 0.3333333333333333, got 0.5",
        check: |c| {
            check(c, |mut n, base| {
                let (mut sum, mut place) = (0.0, 0.5);
                while n > 0 {
                    sum += f64::from(n % base) * place;
                    place /= 2.0;
                    n /= base;
                }
                sum
            });
        },
    },
    Wrong {
        mistake: "mirrored in 32 bits, which overflow",
        says: "2147483648 in base 2: expected 2.3283064365386963e-10, got inf",
        check: |c| {
            check(c, |mut n, base| {
                let (mut mirrored, mut scale) = (0_u32, 1_u32);
                while n > 0 {
                    mirrored = mirrored.wrapping_mul(base).wrapping_add(n % base);
                    scale = scale.wrapping_mul(base);
                    n /= base;
                }
                f64::from(mirrored) / f64::from(scale)
            });
        },
    },
];
