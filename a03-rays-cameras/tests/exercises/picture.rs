//! Pictures of all samplings, compared with the lesson's `render`.

use std::sync::Arc;

use crate::prelude::*;

yours! { picture => std::sync::Arc::new(picture) }

type Radiance<'a> = &'a (dyn Fn(&Ray) -> Color + Sync);
type Code = Arc<dyn Fn(&dyn Camera, Radiance, &Settings) -> Result<Image, Error> + Send + Sync>;
type Other = Variant<Code>;

pub fn picture(
    camera: &dyn Camera,
    radiance: Radiance,
    settings: &Settings,
) -> Result<Image, Error> {
    render(camera, radiance, settings, &())
}

pub fn exercise() -> Exercise<Code> {
    let pixels = Questions {
        words: "{} sampling, {} samples, picture of {} pixels: the mean of (x, y, x²) in column \
                and row {}"
            .into(),
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
        questions: vec![pixels.into()],
        picture: scene(|picture: &Code, settings, View { camera, world: sky }| {
            picture(&camera, &|ray| sky.color_for(ray), settings)
        }),
        right: vec![Other::new(
            "a running mean",
            painted(Style {
                is_flipped: false,
                pixel: running_mean,
            }),
        )],
        wrong: vec![
            Other::new(
                "rows are counted from the top",
                painted(Style {
                    is_flipped: true,
                    pixel: running_mean,
                }),
            ),
            Other::new(
                "a grid may have fewer samples",
                painted(Style {
                    is_flipped: false,
                    pixel: |samples, wanted| sum(samples) * (1.0 / f64::from(wanted)),
                }),
            ),
            Other::new(
                "a pixel is a mean, not a sum",
                painted(Style {
                    is_flipped: false,
                    pixel: |samples, _| sum(samples),
                }),
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

/// Another way to paint a picture.
#[derive(Clone, Copy)]
struct Style {
    /// Whether rows are counted from the top.
    is_flipped: bool,
    /// The colour of a pixel, of the colours of its samples and their wanted number.
    pixel: fn(&[Color], u32) -> Color,
}

fn painted(style: Style) -> Code {
    Arc::new(move |camera, radiance, settings| {
        let (size, sampler) = (settings.size, Sampler::new(settings));
        Image::from_fn(size, |x, y| {
            let row = if style.is_flipped {
                size.height() - 1 - y
            } else {
                y
            };
            let mut samples = Vec::new();
            for place in sampler.places(x, y) {
                let (x, y) = camera_coordinates(size, x, row, place);
                samples.push(radiance(&camera.ray_for(size, x, y)));
            }
            (style.pixel)(&samples, settings.samples)
        })
    })
}

fn running_mean(samples: &[Color], _: u32) -> Color {
    let mut mean = Color::BLACK;
    for (n, color) in (1_u32..).zip(samples) {
        mean += (*color - mean) * (1.0 / f64::from(n));
    }
    mean
}

fn sum(samples: &[Color]) -> Color {
    let mut sum = Color::BLACK;
    for color in samples {
        sum += *color;
    }
    sum
}
