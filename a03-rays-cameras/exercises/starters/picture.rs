//! `picture`: the loop over the pixels, and the mean over the samples of each.
//!
//! Chapter: Rays and cameras, sections "Many rays a pixel" and "The only loop". To compare
//! afterwards: `a03-rays-cameras/src/render.rs`.

use a03_rays_cameras::{Camera, Ray, Sampler, camera_coordinates};
use common::{Color, Error, Image, Settings};

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
    testing::missing("the colour of each pixel", ());
    Ok(image)
}
