//! Rays to stripes and beyond them, compared with the solution.

use a03_rays_cameras::instruments::recorded::push_stripe;

use crate::prelude::*;

yours! { Sky => |camera: &PinholeCamera, size, stripes, ray: &Ray| Ok(Sky::new(camera, size, stripes)?.stripe(ray)) }

/// The number of the stripe along a ray in the sky of a camera, the size of its picture, and a number of
/// stripes.
pub type Code = fn(&PinholeCamera, Size, u32, &Ray) -> Made<u32>;

type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let rays = Questions {
        words: "field of view {}, {} stripes, direction {}",
        simple: vec![
            (1.0, 10, [0.0, 0.0, -1.0]),
            (1.0, 10, [0.0, 1.0, 0.0]),
            (1.0, 10, [0.0, -1.0, 0.0]),
            (1.0, 10, [0.0, 0.1, -1.0]),
            (1.0, 10, [0.0, -0.1, -1.0]),
            (1.0, 1, [0.0, 0.1, -1.0]),
        ],
        others: random(|r| (r.between(0.2, 2.8), 1 + r.below(12), r.triple(1.0))),
        answer: |stripe: &Code, (angle, stripes, d)| {
            let ray = Ray::new(Point3::ORIGIN, vector(d)).ok()?;
            let camera = PinholeCamera::new(Point3::ORIGIN, angle).ok()?;
            stripe(&camera, Size::COURSE, stripes, &ray).ok()
        },
    };
    Exercise {
        questions: rays.into(),
        picture: Picture::scene("striped-sky", |stripe: &Code, settings| {
            let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2)?;
            let radiance = |ray: &Ray| {
                let number = stripe(&camera, settings.size, 10, ray).unwrap_or_default();
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
                |camera, size, n, ray| {
                    Ok(((height(camera, size, ray) + 1.0) / 2.0 * f64::from(n)) as u32)
                },
            ),
            Other::new("stripes are counted from below", |camera, size, n, ray| {
                let number = (1.0 - height(camera, size, ray)) / 2.0 * f64::from(n);
                Ok((number as u32).min(n - 1))
            }),
            Other::new(
                "n stripes fill the picture, not n - 1",
                |camera, size, n, ray| {
                    Ok(((height(camera, size, ray) + 1.0) / 2.0 * f64::from(n - 1)) as u32)
                },
            ),
            Other::new(
                "a number of a stripe is rounded down",
                |camera, size, n, ray| {
                    let number = (height(camera, size, ray) + 1.0) / 2.0 * f64::from(n);
                    Ok((number.round() as u32).min(n - 1))
                },
            ),
        ],
        ..Exercise::default()
    }
}

/// The height of a ray, from -1 at the lower edge to 1 at the upper one.
fn height(camera: &PinholeCamera, size: Size, ray: &Ray) -> f64 {
    let upper = camera.generate_ray(size, f64::from(size.width()) / 2.0, 0.0);
    ray.direction().y() / upper.direction().y()
}
