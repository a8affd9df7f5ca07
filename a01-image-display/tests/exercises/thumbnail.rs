//! Pictures of one white pixel, and one whose means are known.

use a01_image_display::ShowImage;
use common::{Color, Error, Image, Size};
use measure::extremes::Bound;
use testing::exercise::Check;

pub fn check(check: &mut Check, thumbnail: impl Fn(&Image, u32) -> Result<Image, Error>) {
    let size = |width, height| Size::new(width, height).map_err(Error::from);
    let small = |image: &Result<Image, Error>, n| {
        let image = image.as_ref().ok()?;
        thumbnail(image, n).ok()
    };

    for (width, height, n) in [
        (6, 4, 2),
        (7, 5, 2),
        (7, 5, 3),
        (5, 7, 4),
        (3, 2, 1),
        (3, 2, 9),
    ] {
        let columns = |n: u32, length: u32| length / n + u32::from(!length.is_multiple_of(n));
        let (wide, high) = (columns(n, width), columns(n, height));
        let name = format!("{width}x{height} by {n}");
        let white = (0..width * height).map(|i| (i % width, i / width));
        for (at_x, at_y) in white {
            let image = size(width, height).and_then(|size| {
                Image::from_fn(size, |x, y| {
                    Color::gray(f64::from(u8::from((x, y) == (at_x, at_y))))
                })
            });
            let got = small(&image, n);
            let got_size = got.as_ref().map(|got| {
                let size = got.size();
                [f64::from(size.width()), f64::from(size.height()), 1.0]
            });
            let exact = [f64::from(wide), f64::from(high), 1.0];
            check.expect(
                format!("width and height of {name}"),
                Some(exact),
                Bound::Equal,
                got_size,
            );
            // A square that the edge cuts off has fewer pixels.
            let (left, top) = (at_x / n * n, at_y / n * n);
            let pixels = n.min(width - left) * n.min(height - top);
            for (x, y) in (0..high).flat_map(|y| (0..wide).map(move |x| (x, y))) {
                let is_here = (x, y) == (at_x / n, at_y / n);
                let exact = f64::from(u8::from(is_here)) / f64::from(pixels);
                let got = got.as_ref().and_then(|got| got.get(x, y));
                let what = format!("pixel ({x}, {y}) of {name}, white at ({at_x}, {at_y})");
                check.expect(
                    what,
                    Some([exact; 3]),
                    Bound::Equal,
                    got.map(Color::channels),
                );
            }
        }
    }

    // Bright light must not be cut off before the mean is taken.
    let bright = size(2, 1).and_then(|size| {
        Image::from_fn(size, |x, _| {
            let x = f64::from(x);
            Color::new(4.0 * x, 0.25, 1.0 - x)
        })
    });
    let got = small(&bright, 2).and_then(|small| small.get(0, 0));
    check.expect(
        "the mean of (0, 0.25, 1) and (4, 0.25, 0)",
        Some([2.0, 0.25, 0.5]),
        Bound::Equal,
        got.map(Color::channels),
    );

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
