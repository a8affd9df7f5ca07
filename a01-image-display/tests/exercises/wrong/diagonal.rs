//! Wrong solutions.

use common::{Color, Image, Size};
use testing::exercise::{Check, Wrong};

use crate::diagonal;

fn check(check: &mut Check, is_red: fn(Size, u32, u32) -> bool) {
    diagonal::check(check, |size| {
        let red = |x, y| {
            if is_red(size, x, y) {
                Color::RED
            } else {
                Color::BLACK
            }
        };
        Image::from_fn(size, red)
    });
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the picture is stretched into a square",
        says: "of a wide picture",
        check: |c| {
            check(c, |size, x, y| {
                u64::from(x) * u64::from(size.height()) == u64::from(y) * u64::from(size.width())
            });
        },
    },
    Wrong {
        mistake: "rows counted from below",
        says: "column 0, row 0 of 3x3: expected (1, 0, 0), got (0, 0, 0)",
        check: |c| check(c, |size, x, y| x == size.height() - 1 - y),
    },
    Wrong {
        mistake: "the last pixel is left out",
        says: "column 2, row 2 of 3x3",
        check: |c| check(c, |size, x, y| x == y && y + 1 < size.height()),
    },
];
