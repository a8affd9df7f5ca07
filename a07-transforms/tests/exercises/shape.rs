//! Helpers of the checks of shapes and transforms.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Ray, render};
use a04_intersections::{Interval, World};
use common::{ArgumentError, Color};
use testing::exercise::Check;

/// Sine and cosine of angles at which both are fractions.
pub const TURNS: [(f64, f64); 6] = [
    (0.0, 1.0),
    (1.0, 0.0),
    (0.6, -0.8),
    (-0.28, 0.96),
    (-12.0 / 13.0, -5.0 / 13.0),
    (8.0 / 17.0, 15.0 / 17.0),
];

/// Shows a world to an eye that looks at the point `at`. Surfaces that face
/// right, up or the eye are brighter than others.
pub fn show(
    check: &mut Check,
    world: Result<World<Color>, ArgumentError>,
    eye: Point3,
    at: Point3,
) {
    check.picture(|settings| {
        let world = world?;
        let up = Vector3::new(0.0, 1.0, 0.0);
        let camera = PerspectiveCamera::new(eye, at - eye, up, FRAC_PI_4)?;
        let paint = |ray: &Ray| match world.hit(ray, Interval::AHEAD) {
            Some((hit, &color)) => {
                let n = hit.normal;
                color * (0.5 + 0.15 * n.x() + 0.3 * n.y() + 0.2 * n.z())
            }
            None => world.background(),
        };
        render(&camera, paint, settings, &())
    });
}
