//! Lines with gaps, with steps in wrong places, and of wrong length.

use common::{Color, Error, Image, Size};
use testing::exercise::Wrong;

use crate::line::check;
use crate::solutions::line::line;

/// The picture with these blue pixels, given the last column and row.
fn blue<P: Iterator<Item = (u32, u32)>>(
    size: Size,
    pixels: impl Fn(u32, u32) -> P,
) -> Result<Image, Error> {
    let mut image = Image::black(size)?;
    for (x, y) in pixels(size.width() - 1, size.height() - 1) {
        image.set(x, y, Color::BLUE);
    }
    Ok(image)
}

/// `i` steps of `length / steps`, rounded.
fn share(i: u32, length: u32, steps: u32) -> u32 {
    (f64::from(i) * f64::from(length) / f64::from(steps.max(1))).round() as u32
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "one pixel in every column also of a high picture",
        says: "blue pixels in a picture of 5x9: expected 9, got 5",
        check: |c| {
            check(c, |size| {
                blue(size, |w, h| (0..=w).map(move |x| (x, h - share(x, h, w))))
            });
        },
    },
    Wrong {
        mistake: "rounded down, not to the nearest",
        says: "from the line, in pixels, in 64x48: expected 0, got 0.98",
        check: |c| {
            check(c, |size| {
                blue(size, |w, h| {
                    let steps = w.max(h);
                    (0..=steps).map(move |i| (i * w / steps.max(1), h - i * h / steps.max(1)))
                })
            });
        },
    },
    Wrong {
        mistake: "a slope of whole numbers",
        says: "upper right corner in a picture of 9x5: expected 1, got 0",
        check: |c| {
            check(c, |size| {
                blue(size, |w, h| {
                    let steps = w.max(h);
                    let (right, up) = (w / steps.max(1), h / steps.max(1));
                    (0..=steps).map(move |i| (i * right, h - i * up))
                })
            });
        },
    },
    Wrong {
        mistake: "from the upper left corner",
        says: "lower left corner in a picture of 5x5: expected 1, got 0",
        check: |c| {
            check(c, |size| {
                blue(size, |w, h| {
                    let steps = w.max(h);
                    (0..=steps).map(move |i| (share(i, w, steps), share(i, h, steps)))
                })
            });
        },
    },
    Wrong {
        mistake: "without the last pixel",
        says: "upper right corner in a picture of 5x5: expected 1, got 0",
        check: |c| {
            check(c, |size| {
                blue(size, |w, h| {
                    let steps = w.max(h);
                    (0..steps).map(move |i| (share(i, w, steps), h - share(i, h, steps)))
                })
            });
        },
    },
    Wrong {
        mistake: "the width where the last column is meant",
        says: "from the line, in pixels, in 64x48: expected 0, got 0.74",
        check: |c| {
            check(c, |size| {
                blue(size, |w, h| {
                    let steps = w.max(h);
                    (0..=steps).map(move |i| {
                        (
                            share(i, w + 1, steps + 1),
                            h - share(i, h + 1, steps + 1).min(h),
                        )
                    })
                })
            });
        },
    },
    Wrong {
        mistake: "both pixels at each step",
        says: "blue pixels in a picture of 5x5: expected 5, got 9",
        check: |c| {
            check(c, |size| {
                let mut image = line(size)?;
                for x in 1..size.width() {
                    for y in 0..size.height() {
                        let right = image.get(x, y) == Some(Color::BLUE);
                        if right && image.get(x - 1, y) != Some(Color::BLUE) {
                            image.set(x - 1, y, Color::BLUE);
                        }
                    }
                }
                Ok(image)
            });
        },
    },
    Wrong {
        mistake: "white instead of blue",
        says: "blue pixels in a picture of 5x5: expected 5, got 0",
        check: |c| {
            check(c, |size| {
                Ok(line(size)?.map(|c| if c == Color::BLUE { Color::WHITE } else { c }))
            });
        },
    },
];
