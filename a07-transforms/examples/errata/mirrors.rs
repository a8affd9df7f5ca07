//! The reflected ray that begins a thousandth too early.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Ray, View};
use a04_intersections::{Plane, Sphere};
use a05_lighting::PointLight;
use a06_shadows_reflection::protocol::OneCounter;
use a06_shadows_reflection::{LightSource, RecursiveTracer, Reflective, ShadowedWorld};
use common::{Color, Error, Scene, Settings};

use super::{beside, traced};

/// How large the scene is: one of millimetres, measured in metres.
const SIZE: f64 = 0.001;

pub fn offset() -> Scene {
    beside(
        "mirror",
        "three mirroring balls of radius 0.001: reflected at t - 0.001, and lifted",
        |settings| {
            balls(settings, |world, ray, recursion| {
                OneCounter { world, recursion }.trace(ray)
            })
        },
        |settings| {
            balls(settings, |world, ray, depth| {
                RecursiveTracer::new(world).trace(ray, depth)
            })
        },
    )
    .reflecting()
}

/// The spheres of the stage's first scene, closer together.
fn balls(
    settings: &Settings,
    trace: fn(&ShadowedWorld, &Ray, depth: u32) -> Color,
) -> Result<View, Error> {
    let half = Color::gray(0.5);
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let mirror = Reflective::new(Color::gray(0.3), Color::BLACK, 64.0, half)?;
    let light = Point3::new(8.0 * SIZE, 8.0 * SIZE, 8.0 * SIZE);
    let light = PointLight::new(Color::WHITE, light)?;
    let mut world = ShadowedWorld::empty(Color::BLACK, Color::gray(0.25))?
        .with(floor, Box::new(mirror))
        .lit_by(LightSource::new(light, true));
    for (x, color) in [(-2.2, Color::RED), (0.0, Color::GREEN), (2.2, Color::BLUE)] {
        let sphere = Sphere::new(Point3::new(x * SIZE, SIZE, 0.0), SIZE)?;
        let material = Reflective::new(color, Color::WHITE, 64.0, half)?;
        world = world.with(sphere, Box::new(material));
    }
    let eye = Point3::new(4.0 * SIZE, 4.0 * SIZE, 9.0 * SIZE);
    let (gaze, up) = (Vector3::new(-4.0, -3.5, -9.0), Vector3::new(0.0, 1.0, 0.0));
    let camera = PerspectiveCamera::new(eye, gaze, up, FRAC_PI_4)?;
    let depth = settings.depth;
    Ok(traced(camera, move |ray| trace(&world, ray, depth)))
}
