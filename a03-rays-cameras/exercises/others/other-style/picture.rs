//! `picture` pixel by pixel of the list, whose colours are counted.

use crate::prelude::*;

pub fn picture(
    camera: &dyn Camera,
    radiance: &(dyn Fn(&Ray) -> Color + Sync),
    settings: &Settings,
) -> Result<Image, Error> {
    let (size, sampler) = (settings.size, Sampler::new(settings));
    let mut image = Image::black(size)?;
    let mut index = 0;
    for pixel in image.pixels_mut() {
        let (column, row) = (index % size.width(), index / size.width());
        let mut colors = Vec::new();
        for place in sampler.places(column, row) {
            let (x, y) = camera_coordinates(size, column, row, place);
            colors.push(radiance(&camera.ray_for(size, x, y)));
        }
        let sum = colors.iter().fold(Color::BLACK, |sum, color| sum + *color);
        *pixel = sum * (1.0 / colors.len() as f64);
        index += 1;
    }
    Ok(image)
}
