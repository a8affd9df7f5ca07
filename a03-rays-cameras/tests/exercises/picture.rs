//! Pictures of all samplings, compared with the solution.

use crate::prelude::*;

yours! { picture }

type Radiance<'a> = &'a (dyn Fn(&Ray) -> Color + Sync);
type Code = fn(&dyn Camera, Radiance, &Settings) -> Result<Image, Error>;

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
        answer: |picture: &Code, asked| {
            // Not linear, so that the mean of the colours is not the colour of the mean.
            let radiance = |ray: &Ray| {
                let (x, y) = (ray.origin().x(), ray.origin().y());
                Color::new(x, y, x * x)
            };
            pixel(picture, &radiance, asked)
        },
    };
    // A black sample counts, too.
    let edges = Questions {
        words: "{} sampling, {} samples, picture of {} pixels: the mean of white from x = {} on, and black before, \
                in column and row {}",
        simple: vec![(Sampling::Regular, 4, [3, 2], 1.0, [1, 0])],
        others: random(|r| {
            let size = [1 + r.below(5), 1 + r.below(5)];
            let grids = [Sampling::Regular, Sampling::Random, Sampling::Stratified];
            let place = size.map(|n| r.below(n));
            let edge = f64::from(place[0]) + r.between(-0.5, 0.5);
            (
                grids[r.below(3) as usize],
                2 + r.below(8),
                size,
                edge,
                place,
            )
        }),
        answer: |picture: &Code, (sampling, samples, size, edge, place)| {
            let radiance = move |ray: &Ray| Color::gray(f64::from(ray.origin().x() >= edge));
            pixel(picture, &radiance, (sampling, samples, size, place))
        },
    };
    Exercise {
        questions: all([pixels.into(), edges.into()]),
        picture: Picture::scene("striped-sky", |picture: &Code, settings| {
            let View { camera, world } = scenes::striped_sky(settings.size, StripeRule::Direction)?;
            picture(&*camera, &|ray| world.color_for(ray), settings)
        }),
        ..Exercise::default()
    }
}

/// The colour of a pixel, if the rays begin at their positions in the picture.
fn pixel(
    picture: &Code,
    radiance: Radiance,
    (sampling, samples, [width, height], [x, y]): (Sampling, u32, [u32; 2], [u32; 2]),
) -> Option<[f64; 3]> {
    let ahead = Vector3::new(0.0, 0.0, -1.0);
    let camera =
        OwnCamera(move |_: [f64; 2], [x, y]: [f64; 2]| Ray::derived(Point3::new(x, y, 0.0), ahead));
    let settings = Settings {
        size: Size::new(width, height).ok()?,
        sampling,
        samples,
        ..Settings::default()
    };
    let image = picture(&camera, radiance, &settings).ok()?;
    image.get(x, y).map(Color::channels)
}
