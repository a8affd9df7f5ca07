//! The reflected ray that begins a thousandth too early.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Ray, render};
use a04_intersections::{Plane, Sphere};
use a05_lighting::PointLight;
use a06_shadows_reflection::protocol::OneCounter;
use a06_shadows_reflection::{LightSource, RecursiveTracer, Reflective, ShadowedWorld};
use common::{ArgumentError, Color, Error, Image, Progress, Scene, Settings};

use super::beside;

/// How large the scene is: one of millimetres, measured in metres.
const SIZE: f64 = 0.001;

pub fn offset() -> Scene {
    beside(
        "mirror",
        "three mirroring balls of radius 0.001: reflected at t - 0.001, and lifted",
        |settings, progress| {
            let world = balls()?;
            let radiance = |ray: &Ray| {
                let mut tracer = OneCounter {
                    world: &world,
                    recursion: settings.depth,
                };
                tracer.trace(ray)
            };
            view(radiance, settings, progress)
        },
        |settings, progress| {
            let world = balls()?;
            let tracer = RecursiveTracer::new(&world);
            view(|ray| tracer.trace(ray, settings.depth), settings, progress)
        },
    )
    .reflecting()
}

fn view(
    radiance: impl Fn(&Ray) -> Color + Sync,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let eye = Point3::new(4.0 * SIZE, 4.0 * SIZE, 9.0 * SIZE);
    let (gaze, up) = (Vector3::new(-4.0, -3.5, -9.0), Vector3::new(0.0, 1.0, 0.0));
    let camera = PerspectiveCamera::new(eye, gaze, up, FRAC_PI_4)?;
    render(&camera, radiance, settings, progress)
}

/// The spheres of the stage's first scene, closer together.
fn balls() -> Result<ShadowedWorld, ArgumentError> {
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
    Ok(world)
}
