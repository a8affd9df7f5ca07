//! Rays to stripes and beyond them, compared with the solution.

use a03_rays_cameras::instruments::instrumented::push_stripe;

use crate::prelude::*;

yours! { Sky => |camera: &PinholeCamera, size, stripes, ray: &Ray| Ok(Sky::new(camera, size, stripes)?.stripe(ray)) }

/// The number of the stripe along a ray in the sky of a camera, the size of its picture, and a number of
/// stripes.
pub type Code = fn(&PinholeCamera, Size, u32, &Ray) -> Made<u32>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::scene("striped-sky", |stripe: &Code, settings| {
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
        ..Exercise::asked(|stripe: &Code, (angle, stripes, d)| {
            let ray = Ray::new(Point3::ORIGIN, vector(d)).ok()?;
            let camera = PinholeCamera::new(Point3::ORIGIN, angle).ok()?;
            stripe(&camera, Size::COURSE, stripes, &ray).ok()
        })
    }
}
