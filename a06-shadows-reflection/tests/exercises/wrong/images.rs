//! Images that stand in one mirror only, or at the wrong step.

use testing::exercise::Wrong;

use crate::images::check;
use crate::solutions::images::images;

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "each mirror reflects its own images",
        says: "mirrors 10 apart, lamp at 3, image 2 in the left one: expected -17, got 3",
        check: |c| {
            check(c, |width, lamp, n| {
                let mut images = [lamp; 2];
                for _ in 0..n {
                    images = [-images[0], 2.0 * width - images[1]];
                }
                images
            });
        },
    },
    Wrong {
        mistake: "both mirrors at 0",
        says: "mirrors 10 apart, lamp at 3, image 1 in the right one: expected 17, got -3",
        check: |c| {
            check(
                c,
                |_, lamp, n| if n % 2 == 0 { [lamp; 2] } else { [-lamp; 2] },
            );
        },
    },
    Wrong {
        mistake: "the width once instead of twice",
        says: "mirrors 10 apart, lamp at 3, image 1 in the right one: expected 17, got 7",
        check: |c| {
            check(c, |width, lamp, n| images(width / 2.0, lamp, n));
        },
    },
    Wrong {
        mistake: "one reflection too many",
        says: "mirrors 10 apart, lamp at 3, image 0 in the left one: expected 3, got -3",
        check: |c| check(c, |width, lamp, n| images(width, lamp, n + 1)),
    },
    Wrong {
        mistake: "left and right exchanged",
        says: "mirrors 10 apart, lamp at 3, image 1 in the left one: expected -3, got 17",
        check: |c| {
            check(c, |width, lamp, n| {
                let [left, right] = images(width, lamp, n);
                [right, left]
            });
        },
    },
    Wrong {
        mistake: "the new left image reflected in the right mirror of the same step",
        says: "mirrors 10 apart, lamp at 3, image 1 in the right one: expected 17, got 23",
        check: |c| {
            check(c, |width, lamp, n| {
                let [mut left, mut right] = [lamp; 2];
                for _ in 0..n {
                    left = -right;
                    right = 2.0 * width - left;
                }
                [left, right]
            });
        },
    },
    Wrong {
        mistake: "a lamp in the middle",
        says: "mirrors 10 apart, lamp at 3, image 1 in the left one: expected -3, got -5",
        check: |c| {
            check(c, |width, lamp, n| {
                let lamp = if n == 0 { lamp } else { width / 2.0 };
                images(width, lamp, n)
            });
        },
    },
];
