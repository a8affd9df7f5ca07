//! Directions at known angles from the pole: in the middle of their rings, and just
//! before and behind the border between two.

use std::f64::consts::{FRAC_PI_3, FRAC_PI_4, PI};

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Ray, render};
use common::Color;
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

pub fn check(check: &mut Check, ring: impl Fn(Vector3, Vector3, f64) -> u32 + Sync) {
    // Perpendicular to each other, of length 1.
    let axes = [
        [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]],
        [[0.6, 0.0, -0.8], [0.0, -1.0, 0.0]],
        [[0.28, 0.96, 0.0], [-0.96, 0.28, 0.0]],
    ];
    let mut random = Random::new(1);
    for [pole, aside] in axes {
        let [pole, aside] = [pole, aside].map(|xyz: [f64; 3]| Vector3::from_glam(xyz.into()));
        let mut expect = |exact: u32, part: f64, width: f64, [length, pole_length]: [f64; 2]| {
            let angle = (f64::from(exact) + part) * width;
            if angle > PI {
                return;
            }
            let (sin, cos) = libm::sincos(angle);
            let direction = (pole * cos + aside * sin) * length;
            let got = ring(direction, pole * pole_length, width);
            let rings = f64::from(exact) + part;
            let what = format!(
                "{rings} rings of {width:.3e} radians from the pole, which is {}, direction of length {length}",
                (pole * pole_length).to_glam()
            );
            check.expect(what, exact as usize, Bound::Equal, got as usize);
        };
        for width in [FRAC_PI_4, 0.1, 1e-3, 1e-9] {
            for exact in [0, 1, 2, 3, 17, 31, 3000] {
                for lengths in [[1.0, 1.0], [5.0, 1.0], [0.2, 3.0]] {
                    for part in [0.5, 1e-4, 1.0 - 1e-4] {
                        expect(exact, part, width, lengths);
                    }
                }
            }
        }
        for _ in 0..40 {
            let width = random.between(0.01, 1.5);
            let (exact, part) = (random.below(30), random.between(0.01, 0.99));
            let lengths = [random.between(0.1, 9.0), random.between(0.1, 9.0)];
            expect(exact, part, width, lengths);
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
