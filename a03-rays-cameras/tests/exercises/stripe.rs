//! Rays to stripes and beyond them, compared with the solution.

use a03_rays_cameras::instruments::instrumented::push_stripe;

use crate::prelude::*;

yours! { Sky => |camera: &PinholeCamera, size, stripes, ray: &Ray| Ok(Sky::new(camera, size, stripes)?.stripe(ray)) }

/// The number of the stripe along a ray in the sky of a camera, the size of its picture, and a number of
/// stripes.
pub type Code = fn(&PinholeCamera, Size, u32, &Ray) -> Made<u32>;

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
        others: [
            random(|r| (r.between(0.2, 2.8), 1 + r.below(12), r.triple(1.0))),
            random(beside_border),
        ]
        .concat(),
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
        ..Exercise::default()
    }
}

/// A direction close to the border between two stripes, in pictures of all fields of view.
fn beside_border(r: &mut Random) -> (f64, u32, [f64; 3]) {
    let angle = [1e-3, 0.5, 1.0, 2.0, 3.1][r.below(5) as usize];
    let stripes = 2 + r.below(10);
    let border = 2.0 * f64::from(1 + r.below(stripes - 1)) / f64::from(stripes) - 1.0;
    let beside = [1e-3, 1e-6, -1e-3, -1e-6][r.below(4) as usize];
    let y = (border + beside) * libm::sin(angle / 2.0);
    (angle, stripes, [0.0, y, -(1.0 - y * y).sqrt()])
}
