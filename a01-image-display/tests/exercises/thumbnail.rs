//! Pictures of one white pixel, and random ones whose means are whole numbers of
//! a square's pixels.

use a01_image_display::ShowImage;
use common::{Color, Error, Image, Size};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

pub fn check(check: &mut Check, thumbnail: impl Fn(&Image, u32) -> Result<Image, Error> + Copy) {
    // Bright light must not be cut off before the mean is taken.
    let bright = [[0.0, 0.25, 1.0], [4.0, 0.25, 0.0]];
    let bright = picture(2, 1, |x, _| bright[x as usize]);
    let got = bright.and_then(|bright| thumbnail(&bright, 2).ok()?.get(0, 0));
    let what = "the mean of (0, 0.25, 1) and (4, 0.25, 0)";
    let exact = Some([2.0, 0.25, 0.5]);
    check.expect(what, exact, Bound::Equal, got.map(Color::channels));

    for (width, height, n) in [
        (6, 4, 2),
        (7, 5, 2),
        (7, 5, 3),
        (5, 7, 4),
        (3, 2, 1),
        (3, 2, 9),
    ] {
        for (at_x, at_y) in (0..width * height).map(|i| (i % width, i / width)) {
            let light = |x, y| f64::from(u8::from((x, y) == (at_x, at_y)));
            let name = format!("{width}x{height} by {n}, white at ({at_x}, {at_y})");
            expect_means(check, thumbnail, [width, height, n], &name, light);
        }
    }
    let mut random = Random::new(4);
    for _ in 0..40 {
        let [width, height] = [40; 2].map(|end| 1 + random.below(end));
        let n = 1 + random.below(9);
        let pixels: Vec<_> = (0..width * height).map(|_| random.below(256)).collect();
        let light = |x, y| f64::from(pixels[(y * width + x) as usize]);
        let name = format!("{width}x{height} by {n}, random whole numbers");
        expect_means(check, thumbnail, [width, height, n], &name, light);
    }

    check.picture(|settings| {
        let card = ShowImage::test_card()?.into_image();
        let mut image = Image::black(settings.size)?;
        let (mut top, mut n) = (0, 4);
        while n <= 32 {
            let small = thumbnail(&card, n)?;
            image.paste(0, top, &small);
            top += small.size().height().min(settings.size.height());
            n *= 2;
        }
        Ok(image)
    });
}

fn picture(width: u32, height: u32, color: impl Fn(u32, u32) -> [f64; 3]) -> Option<Image> {
    let size = Size::new(width, height).ok()?;
    let color = |x, y| {
        let [r, g, b] = color(x, y);
        Color::new(r, g, b)
    };
    Image::from_fn(size, color).ok()
}

/// Compares the means of a picture whose red is `light`, a whole number, whose green is
/// the column, and whose blue is the row.
fn expect_means(
    check: &mut Check,
    thumbnail: impl Fn(&Image, u32) -> Result<Image, Error>,
    [width, height, n]: [u32; 3],
    name: &str,
    light: impl Fn(u32, u32) -> f64,
) {
    let channels = |x, y| [light(x, y), f64::from(x), f64::from(y)];
    let Some(large) = picture(width, height, channels) else {
        return;
    };
    let got = thumbnail(&large, n);
    let [wide, high] = [width, height].map(|length| length / n + u32::from(length % n > 0));
    for (what, exact, of) in [
        ("width", wide, Size::width as fn(Size) -> u32),
        ("height", high, Size::height),
    ] {
        let got = got.as_ref().ok().map(|got| of(got.size()) as usize);
        check.expect(
            format!("{what} of {name}"),
            Some(exact as usize),
            Bound::Equal,
            got,
        );
    }
    for (x, y) in (0..high).flat_map(|y| (0..wide).map(move |x| (x, y))) {
        // A square that the edge cuts off has fewer pixels.
        let columns = x * n..((x + 1) * n).min(width);
        let rows = y * n..((y + 1) * n).min(height);
        let pixels = f64::from(columns.len() as u32 * rows.len() as u32);
        let mut sum = [0.0; 3];
        for (x, y) in rows.flat_map(|y| columns.clone().map(move |x| (x, y))) {
            sum = std::array::from_fn(|i| sum[i] + channels(x, y)[i]);
        }
        // Sums of whole numbers are exact.
        let exact = sum.map(|sum| sum / pixels);
        let got = got.as_ref().ok().and_then(|got| got.get(x, y));
        let what = format!("pixel ({x}, {y}) of {name}; green is the column, blue the row");
        let bound = Bound::Ulps(2.0);
        check.expect(what, Some(exact), bound, got.map(Color::channels));
    }
}
