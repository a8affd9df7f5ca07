//! Pinhole cameras at any place, with any opening.

use std::f64::consts::FRAC_PI_2;

use a02_math::Point3;
use a03_rays_cameras::{Camera, StripeRule, render};
use common::ArgumentError;
use testing::exercise::{Check, Random};

use crate::sky::{Known, axes, expect_scene, point};

pub fn check<C: Camera>(check: &mut Check, new: impl Fn(Point3, f64) -> Result<C, ArgumentError>) {
    let mut random = Random::new(32);
    let axes = axes();
    for number in 0..20 {
        // First a camera for which one can compute the rays by heart.
        let (e, angle) = match number {
            0 => (Point3::ORIGIN, FRAC_PI_2),
            _ => (point(&mut random), random.between(0.2, 2.8)),
        };
        let Ok(camera) = new(e, angle) else { continue };
        let words = format!("pinhole at {}, opening angle {angle}", e.to_glam());
        let known = Known {
            camera: &camera,
            e,
            axes,
            angle,
            words,
        };
        known.expect_rays(check, &mut random);
    }
    expect_scene(check, StripeRule::Direction, |settings, sky| {
        let camera = new(Point3::ORIGIN, FRAC_PI_2)?;
        render(&camera, |ray| sky.color_for(ray), settings, &())
    });
}
