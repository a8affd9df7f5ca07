//! Pictures of all samplings, compared with the solution.

use crate::prelude::*;

yours! { picture }

type Radiance<'a> = &'a (dyn Fn(&Ray) -> Color + Sync);
type Code = fn(&dyn Camera, Radiance, &Settings) -> Result<Image, Error>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let pixels = Questions {
        words: "{} sampling, {} samples, picture of {} pixels: the mean of (x, y, x²) in column \
                and row {}",
        simple: vec![
            (Sampling::Center, 1, [2, 3], [0, 0]),
            (Sampling::Center, 1, [2, 3], [1, 0]),
            (Sampling::Center, 1, [2, 3], [0, 2]),
        ],
        others: random(|r| {
            let size = [1 + r.below(5), 1 + r.below(5)];
            let grids = [Sampling::Regular, Sampling::Random, Sampling::Stratified];
            let sampling = grids[r.below(3) as usize];
            (sampling, 1 + r.below(9), size, size.map(|n| r.below(n)))
        }),
        answer: pixel,
    };
    Exercise {
        questions: pixels.into(),
        picture: Picture::scene("striped-sky", |picture: &Code, settings| {
            let View { camera, world } = scenes::striped_sky(settings.size, StripeRule::Direction)?;
            picture(&*camera, &|ray| world.color_for(ray), settings)
        }),
        wrong: vec![
            Other::new(
                "rows are counted from the top",
                |camera, radiance, settings| {
                    painted(
                        camera,
                        radiance,
                        settings,
                        |size, y| size.height() - 1 - y,
                        mean,
                    )
                },
            ),
            Other::new(
                "a grid may have fewer samples",
                |camera, radiance, settings| {
                    painted(
                        camera,
                        radiance,
                        settings,
                        |_, y| y,
                        |samples, wanted| sum(samples) * (1.0 / f64::from(wanted)),
                    )
                },
            ),
            Other::new(
                "a pixel is a mean, not a sum",
                |camera, radiance, settings| {
                    painted(
                        camera,
                        radiance,
                        settings,
                        |_, y| y,
                        |samples, _| sum(samples),
                    )
                },
            ),
        ],
        ..Exercise::default()
    }
}

/// The colour of a pixel, if the rays begin at their positions in the picture.
fn pixel(
    picture: &Code,
    (sampling, samples, [width, height], [x, y]): (Sampling, u32, [u32; 2], [u32; 2]),
) -> Option<[f64; 3]> {
    let ahead = Vector3::new(0.0, 0.0, -1.0);
    let camera =
        OwnCamera(move |_: [f64; 2], [x, y]: [f64; 2]| Ray::derived(Point3::new(x, y, 0.0), ahead));
    // Not linear, so that the mean of the colours is not the colour of the mean.
    let radiance = |ray: &Ray| {
        let (x, y) = (ray.origin().x(), ray.origin().y());
        Color::new(x, y, x * x)
    };
    let settings = Settings {
        size: Size::new(width, height).ok()?,
        sampling,
        samples,
        ..Settings::default()
    };
    let image = picture(&camera, &radiance, &settings).ok()?;
    image.get(x, y).map(Color::channels)
}

/// The picture with another row of the camera, and another colour of a pixel: of the colours of
/// its samples and their wanted number.
fn painted(
    camera: &dyn Camera,
    radiance: Radiance,
    settings: &Settings,
    row: fn(Size, u32) -> u32,
    pixel: fn(&[Color], u32) -> Color,
) -> Result<Image, Error> {
    let (size, sampler) = (settings.size, Sampler::new(settings));
    Image::from_fn(size, |x, y| {
        let mut samples = Vec::new();
        for place in sampler.places(x, y) {
            let (x, y) = camera_coordinates(size, x, row(size, y), place);
            samples.push(radiance(&camera.ray_for(size, x, y)));
        }
        pixel(&samples, settings.samples)
    })
}

fn mean(samples: &[Color], _: u32) -> Color {
    sum(samples) * (1.0 / samples.len() as f64)
}

fn sum(samples: &[Color]) -> Color {
    let mut sum = Color::BLACK;
    for color in samples {
        sum += *color;
    }
    sum
}
