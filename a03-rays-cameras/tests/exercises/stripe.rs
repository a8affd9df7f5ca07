//! Rays to stripes and beyond them, compared with the solution.

use std::sync::Arc;

use a03_rays_cameras::instruments::recorded::push_stripe;

use crate::prelude::*;

yours! { Sky => crate::stripe::new_sky(Sky::new, Sky::stripe) }

/// The number of the stripe along a ray.
pub type Stripe = Box<dyn Fn(&Ray) -> u32 + Send + Sync>;

/// Makes the sky of a camera, the size of its picture, and a number of stripes.
pub type Code = Arc<dyn Fn(&PinholeCamera, Size, u32) -> Made<Stripe> + Send + Sync>;

type Other = Variant<Code>;

/// The code that makes skies by this function, and asks them by the other one.
pub fn new_sky<S: Send + Sync + 'static>(
    new: fn(&PinholeCamera, Size, u32) -> Made<S>,
    stripe: fn(&S, &Ray) -> u32,
) -> Code {
    Arc::new(move |camera, size, stripes| {
        let sky = new(camera, size, stripes)?;
        Ok(Box::new(move |ray: &Ray| stripe(&sky, ray)))
    })
}

pub fn exercise() -> Exercise<Code> {
    let rays = Questions {
        words: "field of view {}, {} stripes, direction {}".into(),
        simple: vec![
            (1.0, 10, [0.0, 0.0, -1.0]),
            (1.0, 10, [0.0, 1.0, 0.0]),
            (1.0, 10, [0.0, -1.0, 0.0]),
            (1.0, 10, [0.0, 0.1, -1.0]),
            (1.0, 10, [0.0, -0.1, -1.0]),
            (1.0, 1, [0.0, 0.1, -1.0]),
        ],
        others: random(|r| (r.between(0.2, 2.8), 1 + r.below(12), r.triple(1.0))),
        answer: |new: &Code, (angle, stripes, d)| {
            let ray = Ray::new(Point3::ORIGIN, vector(d)).ok()?;
            let camera = PinholeCamera::new(Point3::ORIGIN, angle).ok()?;
            let stripe = new(&camera, Size::COURSE, stripes).ok()?;
            Some(stripe(&ray))
        },
    };
    Exercise {
        questions: vec![rays.into()],
        picture: scene(|new: &Code, settings, _| {
            let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2)?;
            let stripe = new(&camera, settings.size, 10)?;
            let radiance = |ray: &Ray| {
                let number = stripe(ray);
                let color = match number % 2 {
                    0 => Color::from_bytes([25, 25, 112]),
                    _ => Color::from_bytes([50, 205, 50]),
                };
                push_stripe(number, color);
                color
            };
            paint(&camera, &radiance, settings)
        }),
        wrong: vec![
            Other::new(
                "above the picture is the last stripe",
                by_height(|height, n| (height + 1.0) / 2.0 * n),
            ),
            Other::new(
                "stripes are counted from below",
                by_height(|height, n| ((1.0 - height) / 2.0 * n).min(n - 1.0)),
            ),
            Other::new(
                "n stripes fill the picture, not n - 1",
                by_height(|height, n| (height + 1.0) / 2.0 * (n - 1.0)),
            ),
            Other::new(
                "a number of a stripe is rounded down",
                by_height(|height, n| (n / 2.0 * (height + 1.0)).round().min(n - 1.0)),
            ),
        ],
        ..Exercise::default()
    }
}

/// The number of a stripe from its height, from -1 at the lower edge to 1 at the upper one,
/// and the count of all stripes.
fn by_height(number: fn(f64, f64) -> f64) -> Code {
    Arc::new(move |camera, size, stripes| {
        let upper = camera.generate_ray(size, f64::from(size.width()) / 2.0, 0.0);
        let top = upper.direction().y();
        Ok(Box::new(move |ray: &Ray| {
            number(ray.direction().y() / top, f64::from(stripes)) as u32
        }))
    })
}
