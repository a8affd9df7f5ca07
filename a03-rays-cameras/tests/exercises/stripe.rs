//! Rays at known heights: in the middle of stripes, on both sides of their borders, and
//! beyond the edges of the picture.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PinholeCamera, Ray, StripeRule, render};
use common::{ArgumentError, Color, Size};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::sky::{camera, expect_scene};

pub fn check<S: Sync>(
    check: &mut Check,
    new: impl Fn(&PinholeCamera, Size, u32) -> Result<S, ArgumentError>,
    stripe: impl Fn(&S, &Ray) -> u32 + Sync,
) {
    let mut random = Random::new(34);
    for count in [2, 10, 3, 7, 1] {
        let angle = random.between(0.5, 2.5);
        let Ok(camera) = PinholeCamera::new(Point3::ORIGIN, angle) else {
            continue;
        };
        let Ok(sky) = new(&camera, Size::COURSE, count) else {
            continue;
        };
        let top = libm::sin(angle / 2.0);
        // From 0 at the lower edge to `count` at the upper one.
        let mut at = |kind: &str, height: f64, exact: u32| {
            let y = top * (2.0 * height / f64::from(count) - 1.0);
            let turn = random.between(-1.0, 1.0);
            let along = (1.0 - y * y).sqrt();
            let d = Vector3::new(along * libm::sin(turn), y, -along * libm::cos(turn));
            let got = stripe(&sky, &Ray::derived(Point3::ORIGIN, d));
            let what = format!(
                "{kind}; {count} stripes, opening angle {angle}, direction {:.4}",
                d.to_glam()
            );
            check.expect(what, exact as usize, Bound::Equal, got as usize);
        };
        for k in 0..count {
            at("in the middle of a stripe", f64::from(k) + 0.5, k);
            at(
                "just above the lower border of a stripe",
                f64::from(k) + 1e-9,
                k,
            );
            at(
                "just below the upper border of a stripe",
                f64::from(k + 1) - 1e-9,
                k,
            );
        }
        let beyond = 0.2 * f64::from(count) * (1.0 / top - 1.0);
        at("below the picture", -beyond, 0);
        at("above the picture", f64::from(count) + beyond, count - 1);
    }
    expect_scene(check, StripeRule::Direction, |settings, _| {
        let camera = camera()?;
        let sky = new(&camera, settings.size, 10)?;
        let radiance = |ray: &Ray| match stripe(&sky, ray) % 2 {
            0 => Color::from_bytes([25, 25, 112]),
            _ => Color::from_bytes([50, 205, 50]),
        };
        render(&camera, radiance, settings, &())
    });
}
