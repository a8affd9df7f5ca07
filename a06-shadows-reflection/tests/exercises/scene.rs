//! Helpers of the pictures of checks.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Ray, render};
use common::Color;
use testing::exercise::Check;

/// Shows the colours of rays from an eye that looks at the point `at`.
pub fn show(check: &mut Check, eye: Point3, at: Point3, color: impl Fn(&Ray) -> Color + Sync) {
    check.picture(|settings| {
        let up = Vector3::new(0.0, 1.0, 0.0);
        let camera = PerspectiveCamera::new(eye, at - eye, up, FRAC_PI_4)?;
        render(&camera, color, settings, &())
    });
}

/// Light and dark squares in all directions, without an end.
pub fn checkered(direction: Vector3) -> Color {
    let d = direction.to_glam();
    let cell = (d / d.abs().max_element() * 4.0 + 0.5)
        .floor()
        .element_sum();
    let shade = if cell.rem_euclid(2.0) == 0.0 {
        0.9
    } else {
        0.25
    };
    Color::new(shade, shade, shade * 0.8 + 0.15)
}
