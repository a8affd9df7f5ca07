//! Pictures of all shapes, compared with the lesson's `PaintDiagonal`.

use crate::prelude::*;

pub fn diagonal(size: Size) -> Result<Image, Error> {
    PaintDiagonal::new(size).image()
}

pub fn check(check: &mut Check, yours: &dyn Fn(Size) -> Result<Image, Error>) {
    check.compare(
        "a picture of {}x{}",
        [(3, 3), (5, 3), (3, 5), (1, 1)],
        random(|r| (1 + r.below(30), 1 + r.below(30))),
        [&diagonal as _, yours],
        |diagonal, size| painted(size, diagonal),
    );
    check.scene(&stage(), "diagonal", |settings| yours(settings.size));
}

/// Red in column x and row y of a picture of this width and height.
fn red(is_red: fn([u32; 2], [u32; 2]) -> bool) -> impl Fn(Size) -> Result<Image, Error> {
    move |size| {
        let is_red = |x, y| is_red([x, y], [size.width(), size.height()]);
        let color = |is_red| if is_red { Color::RED } else { Color::BLACK };
        Image::from_fn(size, |x, y| color(is_red(x, y)))
    }
}

variants! { check:
    yours => &diagonal;
    right "a loop over one side" => &|size| {
        let mut image = Image::black(size)?;
        (0..size.height()).for_each(|at| image.set(at, at, Color::RED));
        Ok(image)
    };
    wrong "the line is not stretched to the corner" => &red(|[x, y], [w, h]| x * h == y * w);
    wrong "rows are counted from the top" => &red(|[x, y], [_, h]| x + y + 1 == h);
    wrong "the last row counts, too" => &red(|[x, y], [_, h]| x == y && y + 1 < h);
}
