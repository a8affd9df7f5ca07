//! Pictures that lose pixels, light or an edge.

use common::{Color, Error, Image, Size};
use testing::exercise::Wrong;

use crate::solutions::thumbnail::thumbnail;
use crate::thumbnail::check;

/// The thumbnail in which all squares are divided by this number, given the
/// square's pixels.
fn divided(image: &Image, n: u32, divisor: impl Fn(f64) -> f64) -> Result<Image, Error> {
    let small = thumbnail(image, n)?;
    Image::from_fn(small.size(), |x, y| {
        let cut = |at: u32, length: u32| f64::from(n.min(length - at * n));
        let pixels = cut(x, image.size().width()) * cut(y, image.size().height());
        let mean = small.get(x, y).unwrap_or_default();
        mean.map(|channel| channel * pixels / divisor(pixels))
    })
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "no pixel for squares that the edge cuts off",
        says: "width of 7x5 by 2, white at (0, 0): expected 4, got 3",
        check: |c| {
            check(c, |image, n| {
                let [width, height] = [image.size().width(), image.size().height()];
                let size = Size::new((width / n).max(1), (height / n).max(1))?;
                let small = thumbnail(image, n)?;
                Image::from_fn(size, |x, y| small.get(x, y).unwrap_or_default())
            });
        },
    },
    Wrong {
        mistake: "divided by n * n also at the edge",
        says: "the mean of (0, 0.25, 1) and (4, 0.25, 0): expected (2, 0.25, 0.5), got (1, ",
        check: |c| check(c, |image, n| divided(image, n, |_| f64::from(n * n))),
    },
    Wrong {
        mistake: "divided by n",
        says: "of 6x4 by 2, white at (0, 0); green is the column, blue the row: expected (0.25, 0.5, 0.5), got (0.5, 1, 1)",
        check: |c| check(c, |image, n| divided(image, n, |_| f64::from(n))),
    },
    Wrong {
        mistake: "the sum, not divided",
        says: "the mean of (0, 0.25, 1) and (4, 0.25, 0): expected (2, 0.25, 0.5), got (4, 0.5, 1)",
        check: |c| check(c, |image, n| divided(image, n, |_| 1.0)),
    },
    Wrong {
        mistake: "only the first pixel of each square",
        says: "the mean of (0, 0.25, 1) and (4, 0.25, 0): expected (2, 0.25, 0.5), got (0, 0.25, 1)",
        check: |c| {
            check(c, |image, n| {
                let size = thumbnail(image, n)?.size();
                Image::from_fn(size, |x, y| image.get(x * n, y * n).unwrap_or_default())
            });
        },
    },
    Wrong {
        mistake: "light cut off at 1 before the mean",
        says: "the mean of (0, 0.25, 1) and (4, 0.25, 0): expected (2, 0.25, 0.5), got (0.5,",
        check: |c| {
            check(c, |image, n| {
                let cut = |color: Color| color.map(|channel| channel.clamp(0.0, 1.0));
                thumbnail(&image.clone().map(cut), n)
            });
        },
    },
    Wrong {
        mistake: "columns and rows exchanged",
        says: "width of 6x4 by 2, white at (0, 0): expected 3, got 2",
        check: |c| {
            check(c, |image, n| {
                let small = thumbnail(image, n)?;
                let size = Size::new(small.size().height(), small.size().width())?;
                Image::from_fn(size, |x, y| small.get(y, x).unwrap_or_default())
            });
        },
    },
];
