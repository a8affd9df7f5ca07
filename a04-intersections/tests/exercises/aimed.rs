//! Rays that are aimed at points of a shape, whose distance and normal are known; and
//! the scenes of this stage, with the student's code in them.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{Camera, PerspectiveCamera, Ray, render};
use a04_intersections::{Geometry, Interval, World, stage};
use common::{ArgumentError, Color};
use testing::exercise::{Check, Random};

use crate::shape::expect_hit;

/// Rounding errors of coordinates up to 100, after a square root.
pub const BOUND: f64 = 1e-9;

pub fn point(random: &mut Random, most: f64) -> Point3 {
    Point3::from_glam(random.triple(most).into())
}

/// Three unit vectors perpendicular to each other.
pub fn frame(random: &mut Random) -> [Vector3; 3] {
    random.frame().map(|v| Vector3::from_glam(v.into()))
}

/// A shape, and the words that describe it in messages.
pub struct Shown<'a> {
    pub shape: &'a dyn Geometry,
    pub words: String,
}

impl Shown<'_> {
    /// Expects the point `at` to be the nearest hit of the rays from `from` to `at`, with
    /// the normal `n`: for directions of several lengths, at the ends of intervals, and
    /// not by a ray in the opposite direction unless `behind` is a hit, too.
    pub fn expect_nearest(
        &self,
        check: &mut Check,
        place: &str,
        from: Point3,
        at: Point3,
        n: Normal3,
    ) {
        let way = at - from;
        for steps in [1.0, 0.25, 8.0] {
            let ray = Ray::derived(from, way * (1.0 / steps));
            self.expect(check, place, &ray, Interval::AHEAD, Some((steps, n)));
            let before = Interval::before(steps * (1.0 - 1e-6));
            let place = format!("{place}, but the interval ends before");
            self.expect(check, &place, &ray, before, None);
        }
    }

    /// Expects no hit by the ray from `from` in a direction.
    pub fn expect_none(&self, check: &mut Check, place: &str, from: Point3, d: Vector3) {
        self.expect(check, place, &Ray::derived(from, d), Interval::AHEAD, None);
    }

    pub fn expect(
        &self,
        check: &mut Check,
        place: &str,
        ray: &Ray,
        within: Interval,
        exact: Option<(f64, Normal3)>,
    ) {
        let (o, d) = (ray.origin().to_glam(), ray.direction().to_glam());
        let what = format!("{place}; {}, ray from {o:.2} along {d:.2}", self.words);
        // A hit on a face is as good with t rounded to the interval's end.
        let scale = exact.map_or(1.0, |(t, _)| t.abs().max(1.0));
        expect_hit(
            check,
            &what,
            exact,
            BOUND * scale,
            self.shape.hit(ray, within),
        );
    }
}

/// Compares a scene of this stage that contains the student's shape with its lock. Camera
/// and world are from `src/scenes.rs`.
pub fn expect_scene(
    check: &mut Check,
    name: &str,
    view: impl FnOnce() -> Result<(Box<dyn Camera>, World<Color>), ArgumentError>,
) {
    check.scene(&stage(), name, |settings| {
        let (camera, world) = view()?;
        render(&camera, |ray: &Ray| world.color_for(ray), settings, &())
    });
}

/// The camera of most scenes: at `e`, looking along `g`.
pub fn perspective(e: Point3, g: Vector3) -> Result<Box<dyn Camera>, ArgumentError> {
    let up = Vector3::new(0.0, 1.0, 0.0);
    Ok(Box::new(PerspectiveCamera::new(e, g, up, FRAC_PI_4)?))
}

/// A black world with one object before a camera at the origin.
pub fn alone(
    shape: impl Geometry,
    color: Color,
) -> Result<(Box<dyn Camera>, World<Color>), ArgumentError> {
    let camera = perspective(Point3::ORIGIN, Vector3::new(0.0, 0.0, -1.0))?;
    Ok((camera, World::new(Color::BLACK)?.with(shape, color)))
}
