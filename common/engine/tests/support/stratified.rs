//! Pictures of functions of the place, with stratified samples.

use common::{Color, Image, Size};
use engine::camera_place;
use rayon::iter::{IndexedParallelIterator, IntoParallelRefMutIterator, ParallelIterator};

use super::random::PixelRandom;

/// The picture of `light` with `side` x `side` stratified samples a pixel, as a screen shows
/// it: the channels are from 0 to 1.
pub fn stratified(
    light: impl Fn(f64, f64) -> Color + Sync,
    size: Size,
    side: u32,
    seed: u64,
) -> Image {
    let mut image = Image::black(size).unwrap();
    let pixels = image.pixels_mut().par_iter_mut().enumerate();
    pixels.for_each(|(i, pixel)| {
        let (column, row) = (i as u32 % size.width(), i as u32 / size.width());
        let random = PixelRandom::new(0x5EED + seed, column, row);
        let mut sum = Color::BLACK;
        for i in 0..side * side {
            let in_cell = |cell: u32, n| (f64::from(cell) + random.uniform(n)) / f64::from(side);
            let n = 2 * u64::from(i);
            let place = (in_cell(i % side, n), in_cell(i / side, n + 1));
            let (x, y) = camera_place(size, (column, row), place);
            sum += light(x, y);
        }
        *pixel = shown(sum * (1.0 / f64::from(side * side)));
    });
    image
}

/// A colour as a screen shows it.
pub fn shown(color: Color) -> Color {
    color.map(|channel| channel.clamp(0.0, 1.0))
}
