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
    let is_drawn = |image: &Image, x: u32, y: u32| {
        let color = image.get(x, y);
        color.is_some_and(|color| color != Color::gray(1.0))
    };
    let is_near = |image: &Image, x: u32, y: u32, reach: u32| {
        let around = |at: u32| at.saturating_sub(reach)..=at + reach;
        around(y).any(|y| around(x).any(|x| is_drawn(image, x, y)))
    };
    for (x, y) in (0..960).flat_map(|y| (0..1280).map(move |x| (x, y))) {
        let (left, top) = (x / 2, y / 2);
        let is_lost = is_drawn(&small, left, top) && !is_near(&large, 2 * left, 2 * top, 3);
        let is_added = is_drawn(&large, x, y) && !is_near(&small, left, top, 1);
        assert!(!is_lost && !is_added, "{x}, {y} of the large picture");
    }
}
