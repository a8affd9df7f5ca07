//! A camera whose rays begin at their place in the picture, so that the colour of a pixel
//! says which rays it is the mean of.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{Camera, Ray, Sampler, StripeRule, camera_coordinates};
use common::{Color, Error, Image, Sampling, Settings, Size};
use measure::extremes::Bound;
use testing::exercise::Check;

use crate::sky::{camera, expect_scene};

/// A camera whose rays begin at their place.
struct Places;

impl Camera for Places {
    fn ray_for(&self, _: Size, x: f64, y: f64) -> Ray {
        Ray::derived(Point3::new(x, y, 0.0), Vector3::new(0.0, 0.0, -1.0))
    }
}

type Radiance<'a> = &'a (dyn Fn(&Ray) -> Color + Sync);

pub fn check(
    check: &mut Check,
    render: impl Fn(&dyn Camera, Radiance, &Settings) -> Result<Image, Error>,
) {
    for (sampling, samples) in [
        (Sampling::Center, 1),
        (Sampling::Regular, 4),
        (Sampling::Regular, 5),
        (Sampling::Random, 3),
        (Sampling::Stratified, 9),
    ] {
        for (width, height) in [(3, 2), (2, 5), (1, 1), (17, 9)] {
            let Ok(size) = Size::new(width, height) else {
                continue;
            };
            let settings = Settings {
                size,
                samples,
                sampling,
                ..Settings::default()
            };
            expect_means(check, &settings, render(&Places, &radiance, &settings));
        }
    }
    expect_scene(check, StripeRule::Direction, |settings, sky| {
        render(&camera()?, &|ray| sky.color_for(ray), settings)
    });
}

/// Not linear, so that the mean of the colours is not the colour of the mean.
fn radiance(ray: &Ray) -> Color {
    let (x, y) = (ray.origin().x(), ray.origin().y());
    Color::new(x, y, x * x)
}

fn expect_means(check: &mut Check, settings: &Settings, got: Result<Image, Error>) {
    let (size, sampler) = (settings.size, Sampler::new(settings));
    let words = format!(
        "{size}, {:?} sampling, {} samples",
        settings.sampling, settings.samples
    );
    let right_size = got.as_ref().is_ok_and(|image| image.size() == size);
    check.expect(
        format!("a picture of the right size; {words}"),
        true,
        Bound::Equal,
        right_size,
    );
    let Ok(image) = got else { return };
    for (row, column) in (0..size.height()).flat_map(|y| (0..size.width()).map(move |x| (y, x))) {
        let mut sum = Color::BLACK;
        for place in sampler.places(column, row) {
            let (x, y) = camera_coordinates(size, column, row, place);
            sum += Color::new(x, y, x * x);
        }
        let exact = sum.map(|sum| sum / f64::from(sampler.samples())).channels();
        let got = image.get(column, row).map(Color::channels);
        let what = format!("the mean of (x, y, x²); column {column}, row {row} of {words}");
        check.expect(what, Some(exact), Bound::Absolute(1e-12), got);
    }
}
