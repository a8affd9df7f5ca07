//! `picture`: the loop over the pixels, and the mean over the samples of each.

use crate::prelude::*;

/// A picture of `settings.size`. Each pixel is the mean of `radiance`, the light that
/// comes back along a ray, over the rays of `camera` through its samples.
///
/// `Sampler::new(settings)` has `samples()`, the number of samples of a pixel, and
/// `places(column, row)`, their places in it. `camera_coordinates(size, column, row,
/// place)` makes `(x, y)` for `camera.ray_for(size, x, y)` of this place.
pub fn picture(
    camera: &dyn Camera,
    radiance: &(dyn Fn(&Ray) -> Color + Sync),
    settings: &Settings,
) -> Result<Image, Error> {
    let size = settings.size;
    let sampler = Sampler::new(settings);
    let mut image = Image::black(size)?;
    for row in 0..size.height() {
        for column in 0..size.width() {
            let mut sum = Color::BLACK;
            for place in sampler.places(column, row) {
                let (x, y) = camera_coordinates(size, column, row, place);
                sum += radiance(&camera.ray_for(size, x, y));
            }
            let mean = sum * (1.0 / f64::from(sampler.samples()));
            image.set(column, row, mean);
        }
    }
    Ok(image)
}
