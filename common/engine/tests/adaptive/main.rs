//! Adaptive sampling of functions of the position.

mod bound;
mod report;

use std::sync::Mutex;

use common::{Color, Image, SamplingReport, Settings, Size};
use engine::adaptive::{KnownLight, PixelRandom, render_image};
use measure::experiment::HALF_GREY_LEVEL;

/// Light at a position, counted from the middle of the lower left pixel.
type Light = fn(f64, f64) -> f64;

const BOUNDS: [f64; 4] = [1.0 / 64.0, 1.0 / 128.0, 1.0 / 255.0, HALF_GREY_LEVEL];

/// A disc in the middle of the picture.
const DISC: Light = |x, y| {
    let (x, y) = (x - 41.3, y - 28.6);
    f64::from(u8::from(x * x + y * y < 22.2 * 22.2))
};

/// Settings for pictures of this error.
fn settings(max_error: f64, seed: u64) -> Settings {
    Settings {
        size: Size::new(80, 60).unwrap(),
        samples: 1024,
        max_error: Some(max_error),
        seed,
        ..Settings::default()
    }
}

/// The picture and its report, if no light is brighter than `max_radiance`.
fn adaptive(
    light: impl Fn(f64, f64) -> f64 + Sync,
    max_radiance: f64,
    settings: &Settings,
) -> (Image, SamplingReport) {
    let sampled = Mutex::new(SamplingReport::default());
    let light = |x, y| Color::gray(light(x, y));
    let max_error = settings.max_error.unwrap();
    let known = KnownLight::up_to(max_radiance);
    let image = render_image(max_error, &known, &light, settings, &sampled).unwrap();
    (image, sampled.into_inner().unwrap())
}

/// The picture with `side` x `side` stratified samples per pixel.
fn stratified(light: Light, size: Size, side: u32) -> Image {
    let pixel = |column, row| {
        let random = PixelRandom::new(0x5EED, column, row);
        let sample = |i: u32| {
            let in_cell = |cell: u32, n| (f64::from(cell) + random.uniform(n)) / f64::from(side);
            let n = 2 * u64::from(i);
            let (dx, dy) = (in_cell(i % side, n), in_cell(i / side, n + 1));
            let (x, y) = (f64::from(column), f64::from(size.height() - 1 - row));
            light(x + dx - 0.5, y + dy - 0.5)
        };
        let sum: f64 = (0..side * side).map(sample).sum();
        Color::gray(sum / f64::from(side * side))
    };
    Image::from_fn(size, pixel).unwrap()
}

/// The root mean square difference of the channels as a screen shows them.
fn root_mean_square(a: &Image, b: &Image) -> f64 {
    let shown = |color: &Color| color.r.clamp(0.0, 1.0);
    let pairs = a.pixels().iter().zip(b.pixels());
    let squares = pairs.map(|(a, b)| (shown(a) - shown(b)) * (shown(a) - shown(b)));
    (squares.sum::<f64>() / a.size().pixels() as f64).sqrt()
}
