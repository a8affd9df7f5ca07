//! Pictures of functions of the place, and the error of a picture.

#[path = "../../src/adaptive/random.rs"]
mod random;

use common::{Color, Image, Settings, Size};
use engine::camera_place;

use random::PixelRandom;

/// Settings for pictures of this error.
pub fn settings(max_error: f64) -> Settings {
    Settings {
        size: Size::new(80, 60).unwrap(),
        samples: 1024,
        max_error: Some(max_error),
        ..Settings::default()
    }
}

/// The picture of `light` with `side` x `side` stratified samples a pixel.
pub fn stratified(light: impl Fn(f64, f64) -> Color, size: Size, side: u32) -> Image {
    let pixel = |column, row| {
        let random = PixelRandom::new(0x5EED, column, row);
        let mut sum = Color::BLACK;
        for i in 0..side * side {
            let in_cell = |cell: u32, n| (f64::from(cell) + random.uniform(n)) / f64::from(side);
            let n = 2 * u64::from(i);
            let place = (in_cell(i % side, n), in_cell(i / side, n + 1));
            let (x, y) = camera_place(size, (column, row), place);
            sum += light(x, y);
        }
        sum * (1.0 / f64::from(side * side))
    };
    Image::from_fn(size, pixel).unwrap()
}

/// The root mean square difference of the channels as a screen shows them.
pub fn root_mean_square(a: &Image, b: &Image) -> f64 {
    let channels = |image: &Image| -> Vec<f64> {
        let shown = |color: &Color| color.map(|c| c.clamp(0.0, 1.0)).channels();
        image.pixels().iter().flat_map(shown).collect()
    };
    let (a, b) = (channels(a), channels(b));
    assert_eq!(a.len(), b.len());
    let squares = a.iter().zip(&b).map(|(a, b)| (a - b) * (a - b));
    (squares.sum::<f64>() / a.len() as f64).sqrt()
}
