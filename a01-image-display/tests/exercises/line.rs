//! Pictures of all shapes, in which every pixel's distance from the line is a
//! fraction of whole numbers.

use common::{Color, Error, Image, Size};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

pub fn check(check: &mut Check, line: impl Fn(Size) -> Result<Image, Error>) {
    let shapes = [
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
        (2, 2),
        (20_000, 2),
        (9_999, 101),
    ];
    let mut random = Random::new(3);
    let more = std::iter::repeat_with(|| (1 + random.below(200), 1 + random.below(200)));
    for (width, height) in shapes.into_iter().chain(more.take(40)) {
        let size = Size::new(width, height);
        match size.map_err(Error::from).and_then(&line) {
            Ok(image) => expect_line(check, &image),
            Err(error) => {
                let what = format!("a picture of {width}x{height}: {error}");
                check.expect(what, true, Bound::Equal, false);
            }
        }
    }
    check.picture(|settings| line(settings.size));
}

fn expect_line(check: &mut Check, image: &Image) {
    let size = image.size();
    let (right, bottom) = (i64::from(size.width()) - 1, i64::from(size.height()) - 1);
    let longer = right.max(bottom);
    let mut seen = vec![0_usize; longer as usize + 1];
    let (mut blue, mut farthest, mut other) = (0_usize, (0, 0, 0), 0_usize);
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
            // The distance from the line along the shorter side, times the longer.
            let off: i64 = (x * bottom - up * right).abs();
            farthest = farthest.max((off, x, y));
        }
    }
    let mut expect = |what: &str, exact: usize, got: usize| {
        let what = format!("{what} in a picture of {size}");
        check.expect(what, exact, Bound::Equal, got);
    };
    for (corner, (x, y)) in [
        ("the lower left", (0, bottom)),
        ("the upper right", (right, 0)),
    ] {
        let is_blue = image.get(x as u32, y as u32) == Some(Color::BLUE);
        expect(
            &format!("blue pixels in {corner} corner"),
            1,
            usize::from(is_blue),
        );
    }
    expect("blue pixels", seen.len(), blue);
    let gap = seen.iter().position(|&pixels| pixels == 0);
    let steps = if right >= bottom {
        "columns from the left"
    } else {
        "rows from the bottom"
    };
    if let Some(gap) = gap {
        expect(&format!("blue pixels after {gap} {steps}"), 1, 0);
    }
    let (off, x, y) = farthest;
    let what = format!("distance of column {x}, row {y} from the line, in pixels, in {size}");
    let off = off as f64 / longer.max(1) as f64;
    check.expect(what, 0.0, Bound::Absolute(0.5), off);
    check.expect(
        format!("pixels neither blue nor black in a picture of {size}"),
        0,
        Bound::Equal,
        other,
    );
}
