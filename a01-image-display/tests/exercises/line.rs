//! Pictures of all shapes, in which every pixel's distance from the line is a
//! fraction of whole numbers.

use common::{Color, Error, Image, Size};
use measure::extremes::Bound;
use testing::exercise::Check;

pub fn check(check: &mut Check, line: impl Fn(Size) -> Result<Image, Error>) {
    for (width, height) in [
        (5, 5),
        (9, 5),
        (5, 9),
        (64, 48),
        (48, 64),
        (100, 3),
        (2, 77),
        (7, 1),
        (1, 7),
        (1, 1),
        (20_000, 2),
        (9_999, 101),
    ] {
        let image = Size::new(width, height)
            .map_err(Error::from)
            .and_then(&line);
        let Ok(image) = image else {
            check.expect(
                format!("a picture of {width}x{height}"),
                true,
                Bound::Equal,
                false,
            );
            continue;
        };
        let (right, bottom) = (i64::from(width) - 1, i64::from(height) - 1);
        let longer = right.max(bottom);
        let mut seen = vec![0_usize; longer as usize + 1];
        let (mut blue, mut far, mut other) = (0_usize, 0_usize, 0_usize);
        for (y, row) in (0..).zip(image.rows()) {
            for (x, color) in (0..).zip(row) {
                if *color != Color::BLUE {
                    other += usize::from(*color != Color::BLACK);
                    continue;
                }
                let up: i64 = bottom - y;
                let along = if right >= bottom { x } else { up };
                seen[along as usize] += 1;
                blue += 1;
                // Off the line by at most half a pixel.
                let off: i64 = x * bottom - up * right;
                far += usize::from(2 * off.abs() > longer);
            }
        }
        let gaps = seen.iter().filter(|&&pixels| pixels == 0).count();
        let mut count = |what: &str, exact: usize, got: usize| {
            let what = format!("{what} in a picture of {width}x{height}");
            check.expect(what, exact, Bound::Equal, got);
        };
        count("blue pixels", seen.len(), blue);
        count("gaps", 0, gaps);
        count("pixels off the line", 0, far);
        count("pixels neither blue nor black", 0, other);
    }
    check.picture(|settings| line(settings.size));
}
