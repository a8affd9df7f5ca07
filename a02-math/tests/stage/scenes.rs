//! The picture of this stage at other sizes.

use common::{Color, Image, Settings, Size};

fn vectors(width: u32, height: u32) -> Image {
    let settings = Settings {
        size: Size::new(width, height).unwrap(),
        ..Settings::default()
    };
    let stage = a02_math::stage();
    stage.scenes[0].render(&settings, &()).unwrap()
}

/// The ink in a quarter of the picture, in pixels of pure black.
fn ink(image: &Image, column: usize, row: usize) -> f64 {
    let [width, height] = [image.size().width(), image.size().height()].map(|x| x as usize / 2);
    let rows = image.rows().skip(row * height).take(height);
    let pixels = rows.flat_map(|pixels| &pixels[column * width..][..width]);
    pixels.map(|c| 1.0 - (c.r + c.g + c.b) / 3.0).sum()
}

/// Lines, heads and letters grow with the picture, so their area with its
/// square. Tolerance: where the pieces overlap, their rims count more in the
/// smaller picture.
#[test]
fn a_larger_picture_has_ink_in_proportion() {
    let (small, large) = (vectors(640, 480), vectors(2560, 1920));
    for row in 0..2 {
        for column in 0..2 {
            let ratio = ink(&large, column, row) / (16.0 * ink(&small, column, row));
            assert!((ratio - 1.0).abs() < 0.02, "{column}, {row}: {ratio}");
        }
    }
}

/// All lines keep their places, up to rounding to whole pixels.
#[test]
fn a_larger_picture_shows_the_same_in_the_same_places() {
    let (small, large) = (vectors(640, 480), vectors(1280, 960));
    let is_drawn = |image: &Image, x: i64, y: i64| {
        image
            .get(x as u32, y as u32)
            .is_some_and(|c| c != Color::gray(1.0))
    };
    let near = |image: &Image, x: i64, y: i64, reach: i64| {
        (-reach..=reach).any(|dy| (-reach..=reach).any(|dx| is_drawn(image, x + dx, y + dy)))
    };
    for y in 0..480 {
        for x in 0..640 {
            assert!(
                !is_drawn(&small, x, y) || near(&large, 2 * x, 2 * y, 3),
                "{x}, {y}"
            );
        }
    }
    for y in 0..960 {
        for x in 0..1280 {
            assert!(
                !is_drawn(&large, x, y) || near(&small, x / 2, y / 2, 1),
                "{x}, {y}"
            );
        }
    }
}
