//! Directions at known angles from the pole: in the middle of their rings.

use std::f64::consts::{FRAC_PI_3, FRAC_PI_4, PI};

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Ray, render};
use common::Color;
use measure::extremes::Bound;
use testing::exercise::Check;

pub fn check(check: &mut Check, ring: impl Fn(Vector3, Vector3, f64) -> u32 + Sync) {
    // Perpendicular to each other, of length 1.
    let axes = [
        [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]],
        [[0.6, 0.0, -0.8], [0.0, -1.0, 0.0]],
        [[0.28, 0.96, 0.0], [-0.96, 0.28, 0.0]],
    ];
    for [pole, aside] in axes {
        let [pole, aside] = [pole, aside].map(|xyz: [f64; 3]| Vector3::from_glam(xyz.into()));
        for width in [FRAC_PI_4, 0.1, 1e-3, 1e-9] {
            for exact in [0, 1, 2, 3, 17] {
                let angle = (f64::from(exact) + 0.5) * width;
                if angle > PI {
                    continue;
                }
                let (sin, cos) = libm::sincos(angle);
                for (length, pole_length) in [(1.0, 1.0), (5.0, 1.0), (0.2, 3.0)] {
                    let direction = (pole * cos + aside * sin) * length;
                    let got = ring(direction, pole * pole_length, width);
                    let what = format!(
                        "at the angle {angle:e}, rings as wide as {width:e}, lengths {length} and {pole_length}"
                    );
                    check.expect(what, exact as usize, Bound::Equal, got as usize);
                }
            }
        }
    }
    check.picture(|settings| {
        let [pole, gaze, up] = [[0.3, 0.4, -1.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]
            .map(|xyz| Vector3::from_glam(xyz.into()));
        let camera = PerspectiveCamera::new(Point3::ORIGIN, gaze, up, FRAC_PI_3)?;
        let paint = |ray: &Ray| match ring(ray.direction(), pole, 0.1) % 2 {
            0 => Color::from_bytes([25, 25, 112]),
            _ => Color::from_bytes([50, 205, 50]),
        };
        render(&camera, paint, settings, &())
    });
}
