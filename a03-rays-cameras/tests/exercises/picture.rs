//! Pictures of all samplings, compared with the lesson's `render`.

use crate::prelude::*;

pub fn picture(
    camera: &dyn Camera,
    radiance: &(dyn Fn(&Ray) -> Color + Sync),
    settings: &Settings,
) -> Result<Image, Error> {
    render(camera, radiance, settings, &())
}

type Radiance<'a> = &'a (dyn Fn(&Ray) -> Color + Sync);

pub fn check(
    check: &mut Check,
    yours: &dyn Fn(&dyn Camera, Radiance, &Settings) -> Result<Image, Error>,
) {
    // The rays begin at their place in the picture.
    let ahead = Vector3::new(0.0, 0.0, -1.0);
    let places = Own(move |_, [x, y]: [f64; 2]| Ray::derived(Point3::new(x, y, 0.0), ahead));
    // Not linear, so that the mean of the colours is not the colour of the mean.
    let radiance = |ray: &Ray| {
        let (x, y) = (ray.origin().x(), ray.origin().y());
        Color::new(x, y, x * x)
    };
    check.compare(
        "{} sampling, {} samples, picture of {} pixels: the mean of (x, y, x²) in column and row {}",
        [[0, 0], [1, 0], [0, 2]].map(|place| (Sampling::Center, 1, [2, 3], place)),
        random(|r| {
            let size = [1 + r.below(5), 1 + r.below(5)];
            let grids = [Sampling::Regular, Sampling::Random, Sampling::Stratified];
            let sampling = grids[r.below(3) as usize];
            (sampling, 1 + r.below(9), size, size.map(|n| r.below(n)))
        }),
        [&picture as _, yours],
        |picture, (sampling, samples, [width, height], [x, y])| {
            let settings = Settings {
                size: Size::new(width, height).ok()?,
                sampling,
                samples,
                ..Settings::default()
            };
            let image = picture(&places, &radiance, &settings).ok()?;
            image.get(x, y).map(Color::channels)
        },
    );
    scene(check, |settings, View { camera, world: sky }| {
        yours(&camera, &|ray| sky.color_for(ray), settings)
    });
}

/// A picture whose pixels follow from the colours of their samples and the wanted number, and
/// whose rows are counted from the top or from below.
fn variant(c: &mut Check, is_flipped: bool, mean: fn(&[Color], u32) -> Color) {
    check(c, &|camera, radiance, settings| {
        let (size, sampler) = (settings.size, Sampler::new(settings));
        Image::from_fn(size, |x, y| {
            let row = if is_flipped { size.height() - 1 - y } else { y };
            let samples = sampler.places(x, y).map(|place| {
                let (x, y) = camera_coordinates(size, x, row, place);
                radiance(&camera.ray_for(size, x, y))
            });
            mean(&samples.collect::<Vec<_>>(), settings.samples)
        })
    });
}

fn running_mean(samples: &[Color], _: u32) -> Color {
    let numbered = (1_u32..).zip(samples);
    numbered.fold(Color::BLACK, |mean, (n, color)| {
        mean + (*color - mean) * (1.0 / f64::from(n))
    })
}

/// The sum of the samples over the wanted number.
fn share(samples: &[Color], wanted: u32) -> Color {
    let (samples, weight) = (samples.iter(), 1.0 / f64::from(wanted));
    samples.fold(Color::BLACK, |sum, color| sum + *color * weight)
}

variants! { variant:
    yours => &picture;
    right "a running mean" => false, running_mean;
    wrong "rows are counted from the top" => true, running_mean;
    wrong "a grid may have fewer samples" => false, share;
    wrong "a pixel is a mean, not a sum" => false, |samples, _| share(samples, 1);
}
