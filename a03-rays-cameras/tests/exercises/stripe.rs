//! Rays to stripes and beyond them, compared with the lesson's `StripedSky`.

use crate::prelude::*;

pub struct Sky(StripedSky);

impl Sky {
    pub fn new(camera: &PinholeCamera, size: Size, stripes: u32) -> Result<Self, ArgumentError> {
        StripedSky::new(camera, size, stripes, StripeRule::Direction).map(Self)
    }

    pub fn stripe(&self, ray: &Ray) -> u32 {
        self.0.stripe(ray)
    }
}

pub fn check<S: Sync>(
    check: &mut Check,
    new: impl Fn(&PinholeCamera, Size, u32) -> Made<S>,
    stripe: impl Fn(&S, &Ray) -> u32 + Sync,
) {
    let camera = |angle| PinholeCamera::new(Point3::ORIGIN, angle);
    let codes: [&dyn Fn(&PinholeCamera, u32, &Ray) -> Option<u32>; 2] = [
        &|camera, count, ray| Some(Sky::new(camera, Size::COURSE, count).ok()?.stripe(ray)),
        &|camera, count, ray| Some(stripe(&new(camera, Size::COURSE, count).ok()?, ray)),
    ];
    let ahead = [[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]];
    check.compare(
        "opening angle {}, {} stripes, direction {}",
        ahead.map(|d| (1.0, 10, d)),
        random(|r| (r.between(0.2, 2.8), 1 + r.below(12), r.triple(1.0))),
        codes,
        |code, (angle, count, d)| {
            let ray = Ray::new(Point3::ORIGIN, vector(d)).ok()?;
            code(&camera(angle).ok()?, count, &ray)
        },
    );
    scene(check, |settings, _| {
        let camera = camera(FRAC_PI_2)?;
        let sky = new(&camera, settings.size, 10)?;
        let radiance = |ray: &Ray| match stripe(&sky, ray) % 2 {
            0 => Color::from_bytes([25, 25, 112]),
            _ => Color::from_bytes([50, 205, 50]),
        };
        paint(&camera, &radiance, settings)
    });
}

/// The number of a stripe from its height, from -1 at the lower edge to 1 at the upper one,
/// and the count of all stripes.
fn variant(c: &mut Check, number: fn(f64, f64) -> f64) {
    let new = |camera: &PinholeCamera, size: Size, stripes: u32| {
        let upper = camera.generate_ray(size, f64::from(size.width()) / 2.0, 0.0);
        Ok((upper.direction().y(), f64::from(stripes)))
    };
    check(c, new, |(top, stripes), ray| {
        number(ray.direction().y() / top, *stripes) as u32
    });
}

variants! { variant:
    yours => Sky::new, Sky::stripe;
    right "in halves of the picture" => |height, n| (n / 2.0 * (height + 1.0)).min(n - 1.0);
    wrong "above the picture is the last stripe" => |height, n| (height + 1.0) / 2.0 * n;
    wrong "stripes are counted from below" => |height, n| ((1.0 - height) / 2.0 * n).min(n - 1.0);
    wrong "a number of a stripe is rounded down" => |height, n| {
        (n / 2.0 * (height + 1.0)).round().min(n - 1.0)
    };
}
