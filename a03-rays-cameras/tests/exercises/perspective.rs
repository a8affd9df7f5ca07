//! Perspective cameras at any place, that look into any direction, with any opening.

use std::f64::consts::FRAC_PI_2;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{Camera, StripeRule, render};
use common::ArgumentError;
use testing::exercise::{Check, Random};

use crate::sky::{Known, axes, expect_scene, frame, point};

pub fn check<C: Camera>(
    check: &mut Check,
    new: impl Fn(Point3, Vector3, Vector3, f64) -> Result<C, ArgumentError>,
) {
    let mut random = Random::new(33);
    for number in 0..20 {
        let (e, axes, angle) = match number {
            // A camera for which one can compute the rays by heart.
            0 => (Point3::ORIGIN, axes(), FRAC_PI_2),
            _ => (
                point(&mut random),
                frame(&mut random),
                random.between(0.2, 2.8),
            ),
        };
        let [_, v, w] = axes;
        // The up vector need not be perpendicular to the gaze.
        let (gaze, up) = match number {
            0 => (-w, v),
            _ => (
                -w * random.between(0.5, 3.0),
                v * random.between(0.5, 3.0) + w * random.between(-1.0, 1.0),
            ),
        };
        let Ok(camera) = new(e, gaze, up, angle) else {
            continue;
        };
        let [g, t] = [gaze, up].map(Vector3::to_glam);
        let words = format!(
            "eye {}, gaze {g:.3}, up {t:.3}, opening angle {angle}",
            e.to_glam()
        );
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
        let (gaze, up) = (Vector3::new(0.0, 0.0, -1.0), Vector3::new(0.0, 1.0, 0.0));
        let camera = new(Point3::ORIGIN, gaze, up, FRAC_PI_2)?;
        render(&camera, |ray| sky.color_for(ray), settings, &())
    });
}
