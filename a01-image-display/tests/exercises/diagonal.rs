//! Pictures of all shapes: red where column and row are the same.

use a01_image_display::stage;
use common::{Color, Error, Image, Size};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

pub fn check(check: &mut Check, diagonal: impl Fn(Size) -> Result<Image, Error>) {
    let mut random = Random::new(12);
    let mut sizes = vec![(3, 3), (5, 3), (3, 5), (1, 1), (1, 9), (9, 1)];
    sizes.extend((0..10).map(|_| (1 + random.below(90), 1 + random.below(90))));
    for (width, height) in sizes {
        let Ok(size) = Size::new(width, height) else {
            continue;
        };
        let image = diagonal(size);
        let shape = match (width, height) {
            (w, h) if w > h => "wide",
            (w, h) if w < h => "high",
            _ => "square",
        };
        let right_size = image.as_ref().is_ok_and(|image| image.size() == size);
        let what = format!("a {shape} picture of the size asked for; {width}x{height}");
        check.expect(what, true, Bound::Equal, right_size);
        let Ok(image) = image else { continue };
        for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            let exact = if x == y { Color::RED } else { Color::BLACK };
            let place = if x == y { "on" } else { "beside" };
            let kind = format!("the colour {place} the diagonal of a {shape} picture");
            let what = format!("{kind}; column {x}, row {y} of {width}x{height}");
            let got = image.get(x, y).map(Color::channels);
            check.expect(what, exact.channels(), Bound::Equal, got);
        }
    }
    check.scene(&stage(), "diagonal", |settings| diagonal(settings.size));
}
