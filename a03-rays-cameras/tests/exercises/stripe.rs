//! Rays to stripes and beyond them, compared with the lesson's `StripedSky`.

use crate::prelude::*;

pub fn check<S: Sync>(
    check: &mut Check,
    new: impl Fn(&PinholeCamera, Size, u32) -> Made<S>,
    stripe: impl Fn(&S, &Ray) -> u32 + Sync,
) {
    let camera = |angle| PinholeCamera::new(Point3::ORIGIN, angle);
    let ray = |d| Ray::new(Point3::ORIGIN, vector(d));
    let ahead = [[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]];
    check.compare(
        "opening angle {}, {} stripes, direction {}",
        ahead.map(|d| (1.0, 10, d)),
        random(|r| (r.between(0.2, 2.8), 1 + r.below(12), r.triple(1.0))),
        |(angle, count, d)| {
            let rule = StripeRule::Direction;
            let sky = StripedSky::new(&camera(angle).ok()?, Size::COURSE, count, rule);
            Some(sky.ok()?.stripe(&ray(d).ok()?) as usize)
        },
        |(angle, count, d)| {
            let sky = new(&camera(angle).ok()?, Size::COURSE, count).ok()?;
            Some(stripe(&sky, &ray(d).ok()?) as usize)
        },
    );
    scene(check, |settings, _| {
        let camera = camera(FRAC_PI_2)?;
        let sky = new(&camera, settings.size, 10)?;
        let radiance = |ray: &Ray| match stripe(&sky, ray) % 2 {
            0 => Color::from_bytes([25, 25, 112]),
            _ => Color::from_bytes([50, 205, 50]),
        };
        render(&camera, radiance, settings, &())
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

pub const VARIANTS: &[Variant] = &[
    right("in halves of the picture", |c| {
        variant(c, |height, n| (n / 2.0 * (height + 1.0)).min(n - 1.0));
    }),
    wrong("above the picture is the last stripe", |c| {
        variant(c, |height, n| (height + 1.0) / 2.0 * n);
    }),
    wrong("stripes are counted from below", |c| {
        variant(c, |height, n| ((1.0 - height) / 2.0 * n).min(n - 1.0));
    }),
    wrong("a number of a stripe is rounded down", |c| {
        variant(c, |height, n| {
            (n / 2.0 * (height + 1.0)).round().min(n - 1.0)
        });
    }),
];
