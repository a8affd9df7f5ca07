//! Pictures of several shapes, in which exactly the painted pixel changes.

use a01_image_display::stage;
use common::{Color, Image, Size};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

pub fn check(check: &mut Check, set_pixel: impl Fn(&mut Image, u32, u32, Color)) {
    let mut random = Random::new(11);
    let mut case = |kind: &str, (width, height): (u32, u32), (x, y): (u32, u32)| {
        let image = Size::new(width, height).map(Image::black);
        let Ok(Ok(mut image)) = image else { return };
        set_pixel(&mut image, x, y, Color::RED);
        let painted = image
            .pixels()
            .iter()
            .position(|pixel| *pixel != Color::BLACK);
        let count = image
            .pixels()
            .iter()
            .filter(|pixel| **pixel != Color::BLACK)
            .count();
        let inside = x < width && y < height;
        let words = format!("{kind}; column {x}, row {y} of a picture of {width}x{height}");
        // Row y begins after y whole rows.
        let exact = inside.then(|| (y * width + x) as usize);
        check.expect(
            format!("index of the painted pixel, {words}"),
            exact,
            Bound::Equal,
            painted,
        );
        check.expect(
            format!("number of painted pixels, {words}"),
            usize::from(inside),
            Bound::Equal,
            count,
        );
    };
    case("in a wide picture", (4, 3), (2, 1));
    case("in a high picture", (3, 4), (1, 2));
    for _ in 0..20 {
        let (width, height) = (1 + random.below(50), 1 + random.below(50));
        let (x, y) = (random.below(width), random.below(height));
        case("anywhere", (width, height), (x, y));
        case(
            "in the last column and row",
            (width, height),
            (width - 1, height - 1),
        );
        case("right of the picture", (width, height), (width, y));
        case("below the picture", (width, height), (x, height));
        case("far outside", (width, height), (u32::MAX, u32::MAX));
    }
    check.scene(&stage(), "diagonal", |settings| {
        let mut image = Image::black(settings.size)?;
        for at in 0..settings.size.width() {
            set_pixel(&mut image, at, at, Color::RED);
        }
        Ok(image)
    });
}
