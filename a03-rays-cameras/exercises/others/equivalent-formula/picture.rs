//! `picture` with a mean that grows by a part of each sample.

use crate::prelude::*;

pub fn picture(
    camera: &dyn Camera,
    radiance: &(dyn Fn(&Ray) -> Color + Sync),
    settings: &Settings,
) -> Result<Image, Error> {
    let sampler = Sampler::new(settings);
    let part = 1.0 / f64::from(sampler.samples());
    Image::from_fn(settings.size, |column, row| {
        let mut mean = Color::BLACK;
        for place in sampler.places(column, row) {
            let (x, y) = camera_coordinates(settings.size, column, row, place);
            mean += radiance(&camera.ray_for(settings.size, x, y)) * part;
        }
        mean
    })
}
