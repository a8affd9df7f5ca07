//! Pictures of all samplings, compared with the solution.

use crate::prelude::*;

yours! { picture }

type Radiance<'a> = &'a (dyn Fn(&Ray) -> Color + Sync);
type Code = fn(&dyn Camera, Radiance, &Settings) -> Result<Image, Error>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        forms: vec![
            Form::new(|picture: &Code, pixel: Pixel| {
                // Not linear, so that the mean of the colours is not the colour of the mean.
                let radiance = |ray: &Ray| {
                    let (x, y) = (ray.origin().x(), ray.origin().y());
                    Color::new(x, y, x * x)
                };
                color(picture, &radiance, pixel)
            }),
            // A black sample counts, too.
            Form::new(
                |picture: &Code, (sampling, samples, size, edge, place): (_, _, _, f64, _)| {
                    let radiance =
                        move |ray: &Ray| Color::gray(f64::from(ray.origin().x() >= edge));
                    color(picture, &radiance, (sampling, samples, size, place))
                },
            ),
        ],
        picture: StudentPicture::scene("striped-sky", |picture: &Code, settings| {
            let View { camera, world } = scenes::striped_sky(settings.size, StripeRule::Direction)?;
            picture(&*camera, &|ray| world.color_for(ray), settings)
        }),
        ..Exercise::default()
    }
}

/// Sampling and samples, the size of a picture, and the place of a pixel in it.
type Pixel = (Sampling, u32, [u32; 2], [u32; 2]);

/// The colour of a pixel, if the rays begin at their positions in the picture.
fn color(
    picture: &Code,
    radiance: Radiance,
    (sampling, samples, [width, height], [x, y]): Pixel,
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
