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
        picture: Picture::own(landscape),
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

/// How many pixels wide and high a pixel of the landscape is shown.
const ENLARGED: u32 = 4;

/// A house before a hill under the sun, with large pixels: on the left with one sample of a pixel, on
/// the right with the nine of the largest grid that 15 allow.
fn landscape(picture: &Code, settings: &Settings) -> Result<Image, Error> {
    let half = Size::new(
        settings.size.width() / 2 / ENLARGED,
        settings.size.height() / ENLARGED,
    )?;
    let ahead = Vector3::new(0.0, 0.0, -1.0);
    let camera = OwnCamera(move |[width, _]: [f64; 2], [x, y]: [f64; 2]| {
        Ray::derived(Point3::new(x / width, y / width, 0.0), ahead)
    });
    let halves = [(Sampling::Center, 1), (Sampling::Regular, 15)].map(|(sampling, samples)| {
        let settings = Settings {
            size: half,
            sampling,
            samples,
            ..settings.clone()
        };
        picture(
            &camera,
            &|ray| seen_at(ray.origin().x(), ray.origin().y()),
            &settings,
        )
    });
    let [left, right] = halves;
    let (left, right) = (left?, right?);
    Image::from_fn(settings.size, |x, y| {
        let (column, row) = (x / ENLARGED, y / ENLARGED);
        let color = if column < half.width() {
            left.get(column, row)
        } else {
            right.get(column - half.width(), row)
        };
        let is_gap = x.abs_diff(settings.size.width() / 2) < 2;
        color.filter(|_| !is_gap).unwrap_or(Color::WHITE)
    })
}

/// The colour of the landscape, whose width is 1.
fn seen_at(x: f64, y: f64) -> Color {
    let from_sun = [x - 0.72, y - 1.2];
    let from_middle = (x - 0.42).abs();
    if y < 0.3 {
        Color::new(0.25, 0.5, 0.2)
    } else if from_middle < 0.2 && y < 0.62 {
        Color::new(0.9, 0.85, 0.7)
    } else if y < 0.9 - 1.1 * from_middle && y >= 0.62 {
        Color::new(0.75, 0.2, 0.1)
    } else if y < 0.75 - 0.8 * (x - 0.9) * (x - 0.9) {
        Color::new(0.15, 0.35, 0.25)
    } else if from_sun[0] * from_sun[0] + from_sun[1] * from_sun[1] < 0.014 {
        Color::new(1.0, 0.85, 0.2)
    } else {
        Color::new(0.45, 0.65, 0.95)
    }
}
