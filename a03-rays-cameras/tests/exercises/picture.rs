//! Pictures of all samplings, compared with the lesson's `render`.

use crate::prelude::*;

type Radiance<'a> = &'a (dyn Fn(&Ray) -> Color + Sync);

/// A camera whose rays begin at their place in the picture.
struct Places;

impl Camera for Places {
    fn ray_for(&self, _: Size, x: f64, y: f64) -> Ray {
        Ray::derived(Point3::new(x, y, 0.0), Vector3::new(0.0, 0.0, -1.0))
    }
}

pub fn check(
    check: &mut Check,
    yours: impl Fn(&dyn Camera, Radiance, &Settings) -> Result<Image, Error>,
) {
    use Sampling::{Center, Random, Regular, Stratified};
    type Input = (&'static str, u32, [u32; 2], [u32; 2]);
    // Not linear, so that the mean of the colours is not the colour of the mean.
    let radiance = |ray: &Ray| {
        let (x, y) = (ray.origin().x(), ray.origin().y());
        Color::new(x, y, x * x)
    };
    let pixel = |(sampling, samples, [width, height], [column, row]): Input,
                 render: &dyn Fn(&Settings) -> Result<Image, Error>| {
        let kinds = [
            ("center", Center),
            ("regular", Regular),
            ("random", Random),
            ("stratified", Stratified),
        ];
        let (_, sampling) = kinds.into_iter().find(|(name, _)| *name == sampling)?;
        let size = Size::new(width, height).ok()?;
        let image = render(&Settings {
            size,
            sampling,
            samples,
            ..Settings::default()
        })
        .ok()?;
        let color = image.get(column, row).filter(|_| image.size() == size);
        color.map(Color::channels)
    };
    check.compare(
        "{} sampling, {} samples, picture of {} pixels: the mean of (x, y, x²) in column and row {}",
        [[0, 0], [1, 0], [0, 2]].map(|place| ("center", 1, [2, 3], place)),
        random(|r| {
            let size = [1 + r.below(5), 1 + r.below(5)];
            let sampling = ["center", "regular", "random", "stratified"][r.below(4) as usize];
            (sampling, 1 + r.below(9), size, size.map(|n| r.below(n)))
        }),
        |input| pixel(input, &|settings| render(&Places, radiance, settings, &())),
        |input| pixel(input, &|settings| yours(&Places, &radiance, settings)),
    );
    scene(check, |settings, camera, sky| {
        yours(&camera, &|ray| sky.color_for(ray), settings)
    });
}

/// A picture whose pixels follow from the colours of its samples, which the settings want
/// and which the sampler has.
fn variant(c: &mut Check, row: fn(u32, u32) -> u32, mean: fn(&[Color], u32) -> Color) {
    check(c, |camera, radiance, settings| {
        let (size, sampler) = (settings.size, Sampler::new(settings));
        Ok(Image::from_fn(size, |x, y| {
            let samples: Vec<_> = sampler
                .places(x, y)
                .map(|place| {
                    let (x, y) = camera_coordinates(size, x, row(y, size.height()), place);
                    radiance(&camera.ray_for(size, x, y))
                })
                .collect();
            mean(&samples, settings.samples)
        })?)
    });
}

fn sum(samples: &[Color]) -> Color {
    samples
        .iter()
        .fold(Color::BLACK, |sum, sample| sum + *sample)
}

pub const VARIANTS: &[Variant] = &[
    right("a running mean", |c| {
        variant(
            c,
            |row, _| row,
            |samples, _| {
                let numbered = (1_u32..).zip(samples);
                numbered.fold(Color::BLACK, |mean, (n, sample)| {
                    mean + (*sample - mean) * (1.0 / f64::from(n))
                })
            },
        );
    }),
    wrong("rows are counted from the top, and y from below", |c| {
        let flipped = |row: u32, height: u32| height - 1 - row;
        variant(c, flipped, |samples, _| {
            sum(samples) * (1.0 / samples.len() as f64)
        });
    }),
    wrong("a pixel is the mean of its samples, not their sum", |c| {
        variant(c, |row, _| row, |samples, _| sum(samples));
    }),
    wrong(
        "a grid has fewer samples than the settings say, if they are no square number",
        |c| {
            variant(
                c,
                |row, _| row,
                |samples, wanted| sum(samples) * (1.0 / f64::from(wanted)),
            );
        },
    ),
];
