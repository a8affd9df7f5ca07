//! `picture`: the loop over the pixels, and the mean over the samples of each.

use crate::prelude::*;

/// A picture of `settings.size`. Each pixel is the mean of `radiance`, the light that
/// comes back along a ray, over the rays of `camera` through its samples.
///
/// `Sampler::new(settings)` has `samples()`, the number of samples of a pixel, and
/// `places(column, row)`, their places in it. `camera_coordinates(size, column, row,
/// place)` makes `(x, y)` for `camera.ray_for(size, x, y)` of this place. A colour is scaled by
/// `color * number`. `size.width()` and `size.height()` are the numbers of columns and rows, and
/// `image.set(column, row, color)` paints a pixel.
pub fn picture(
    camera: &dyn Camera,
    radiance: &(dyn Fn(&Ray) -> Color + Sync),
    settings: &Settings,
) -> Result<Image, Error> {
    let size = settings.size;
    let sampler = Sampler::new(settings);
    let mut image = Image::black(size)?;
    // 1. Visit each pixel by column and row.
    // 2. Add up the light along the camera's rays through its samples.
    // 3. Paint the pixel with the mean.
    missing!("the colour of each pixel", (), {
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
    });
    Ok(image)
}

testing::examples! {
    let ahead = Vector3::new(0.0, 0.0, -1.0);
    let places = Own(move |_, [x, y]: [f64; 2]| Ray::derived(Point3::new(x, y, 0.0), ahead));
    let size = Size::new(2, 3).unwrap();
    let radiance = |ray: &Ray| Color::new(ray.origin().x(), ray.origin().y(), 1.0);
    for (sampling, samples) in [(Sampling::Center, 1), (Sampling::Regular, 5)] {
        let settings = Settings { size, sampling, samples, ..Settings::default() };
        let image = picture(&places, &radiance, &settings).unwrap();
        assert_close!(image.get(0, 0), Some(Color::new(0.0, 2.0, 1.0)), "upper left");
        assert_close!(image.get(1, 2), Some(Color::new(1.0, 0.0, 1.0)), "lower right");
    }
}
