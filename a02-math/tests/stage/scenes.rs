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
