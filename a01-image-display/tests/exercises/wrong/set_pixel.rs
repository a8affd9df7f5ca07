//! Wrong solutions.

use common::{Color, Image};
use testing::exercise::{Check, Wrong};

use crate::set_pixel;

/// Paints the pixel at this index of the list, if there is one.
fn check(check: &mut Check, index: fn(u32, u32, u32, u32) -> usize) {
    set_pixel::check(check, |image, x, y, color| {
        let size = image.size();
        let index = index(x, y, size.width(), size.height());
        paint(image, index, color);
    });
}

fn paint(image: &mut Image, index: usize, color: Color) {
    if let Some(pixel) = image.pixels_mut().get_mut(index) {
        *pixel = color;
    }
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "a pixel right of the picture is painted at the left of the next row",
        says: "right of the picture",
        check: |c| check(c, |x, y, width, _| y as usize * width as usize + x as usize),
    },
    Wrong {
        mistake: "rows are taken to be as long as columns",
        says: "in a wide picture",
        check: |c| {
            check(c, |x, y, _, height| {
                y as usize * height as usize + x as usize
            });
        },
    },
    Wrong {
        mistake: "column after column",
        says: "in a wide picture",
        check: |c| {
            check(c, |x, y, _, height| {
                x as usize * height as usize + y as usize
            });
        },
    },
    Wrong {
        mistake: "rows counted from below",
        says: "in a high picture",
        check: |c| {
            check(c, |x, y, width, height| {
                (height as usize)
                    .wrapping_sub(y as usize + 1)
                    .wrapping_mul(width as usize)
                    + x as usize
            });
        },
    },
];
