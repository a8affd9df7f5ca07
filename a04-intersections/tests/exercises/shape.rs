//! Helpers of the checks of shapes.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Ray, render};
use a04_intersections::{Geometry, Hit, Interval, World};
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::Check;

/// Sine and cosine of angles at which both are fractions.
pub const TURNS: [(f64, f64); 8] = [
    (0.0, 1.0),
    (1.0, 0.0),
    (0.6, -0.8),
    (-0.28, 0.96),
    (5.0 / 13.0, 12.0 / 13.0),
    (-12.0 / 13.0, -5.0 / 13.0),
    (8.0 / 17.0, -15.0 / 17.0),
    (-21.0 / 29.0, 20.0 / 29.0),
];

/// Compares `t` and normal of a hit with the exact ones.
pub fn expect_hit(
    check: &mut Check,
    what: &str,
    exact: Option<(f64, Normal3)>,
    bound: f64,
    got: Option<Hit>,
) {
    let bound = Bound::Absolute(bound);
    let (exact_t, got_t) = (exact.map(|(t, _)| t), got.map(|hit| hit.t));
    check.expect(format!("t, {what}"), exact_t, bound, got_t);
    if let (Some((_, exact)), Some(got)) = (exact, got) {
        let [exact, got] = [exact, got.normal].map(|normal| normal.to_glam().to_array());
        check.expect(format!("the normal, {what}"), exact, bound, got);
    }
}

/// A vector turned around the y axis by an angle of this sine and cosine.
pub fn turned((sin, cos): (f64, f64), x: f64, y: f64, z: f64) -> Vector3 {
    Vector3::new(cos * x + sin * z, y, cos * z - sin * x)
}

/// Shows a shape to an eye that looks at the point `at`, coloured by its normal:
/// red faces right or left, green up or down, blue near or far.
pub fn show(check: &mut Check, shape: impl Geometry + 'static, eye: Point3, at: Point3) {
    let world = World::new(Color::gray(0.1)).map(|world| world.with(shape, ()));
    show_world(check, world, eye, at, |_, normal| {
        let [r, g, b] = normal.to_glam().abs().to_array();
        Color::new(r, g, b)
    });
}

/// Shows a world to an eye that looks at the point `at`, coloured by place and
/// normal.
pub fn show_world(
    check: &mut Check,
    world: Result<World<()>, ArgumentError>,
    eye: Point3,
    at: Point3,
    color: impl Fn(Point3, Normal3) -> Color + Sync,
) {
    check.picture(|settings| {
        let world = world?;
        let up = Vector3::new(0.0, 1.0, 0.0);
        let camera = PerspectiveCamera::new(eye, at - eye, up, FRAC_PI_4)?;
        let paint = |ray: &Ray| match world.hit(ray, Interval::AHEAD) {
            Some((hit, ())) => color(ray.at(hit.t), hit.normal),
            None => world.background(),
        };
        render(&camera, paint, settings, &())
    });
}
