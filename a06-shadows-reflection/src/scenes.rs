//! The protocol's test scenes of this stage.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{Camera, PerspectiveCamera, Sampler, render};
use a04_intersections::{AxisAlignedBox, Plane, Sphere};
use a05_lighting::{Lambert, PointLight};
use common::{ArgumentError, Color, Scene, Stage};

use crate::{LightSource, RecursiveTracer, Reflective, ShadowedWorld, experiments, extremes};

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    Stage {
        name: "a06-shadows-reflection",
        about: "Shadows and mirrors",
        scenes: vec![
            scene("sphere", "three mirroring spheres on a mirror", sphere).reflecting(),
            scene("aab", "a box and its shadow", aab),
        ],
        experiments: experiments::experiments,
        extremes: extremes::cases,
    }
}

/// The share of the error allowed that mirrors may take; the samples take the
/// rest, and the squares of both add up to hardly more.
const UNSEEN: f64 = 1.0 / 8.0;

fn scene(
    name: &'static str,
    about: &'static str,
    world: fn() -> Result<ShadowedWorld, ArgumentError>,
) -> Scene {
    Scene::traced(name, about, move |settings, progress| {
        let e = Point3::new(8.0, 8.0, 8.0);
        let (g, t) = (Vector3::new(-1.0, -1.0, -1.0), Vector3::new(0.0, 1.0, 0.0));
        let camera = PerspectiveCamera::new(e, g, t, FRAC_PI_4)?;
        let world = world()?.omitting(settings.omit, camera.focus());
        let tracer = RecursiveTracer::new(&world, settings.omit)
            .cut_below(settings.max_error.map(|error| error * UNSEEN));
        let radiance = |ray: &_| tracer.trace(ray, settings.depth);
        render(&camera, radiance, settings, progress)
    })
    .planned(move |settings| {
        let world = world()?.prepared([]);
        let tracer = RecursiveTracer::new(&world, true)
            .cut_below(settings.max_error.map(|error| error * UNSEEN));
        Ok(tracer.plan(Sampler::plan(settings)))
    })
}

fn floor() -> Result<Plane, ArgumentError> {
    Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))
}

fn sphere() -> Result<ShadowedWorld, ArgumentError> {
    let half = Color::gray(0.5);
    let mirror = Reflective::new(Color::gray(0.1), Color::BLACK, 64.0, half)?;
    let light = PointLight::new(Color::WHITE, Point3::new(8.0, 8.0, 8.0))?;
    let mut world = ShadowedWorld::empty(Color::BLACK, Color::gray(0.25))?
        .with(floor()?, Box::new(mirror))
        .lit_by(LightSource::new(light, true));
    for (x, color) in [(-3.0, Color::RED), (0.0, Color::GREEN), (3.0, Color::BLUE)] {
        let sphere = Sphere::new(Point3::new(x, 1.0, 0.0), 1.0)?;
        let material = Reflective::new(color, Color::WHITE, 64.0, half)?;
        world = world.with(sphere, Box::new(material));
    }
    Ok(world)
}

fn aab() -> Result<ShadowedWorld, ArgumentError> {
    let (lbf, run) = (Point3::new(-0.5, 0.0, -0.5), Point3::new(0.5, 1.0, 0.5));
    let light = PointLight::new(Color::WHITE, Point3::new(8.0, 8.0, 0.0))?;
    Ok(ShadowedWorld::empty(Color::BLACK, Color::gray(0.25))?
        .with(floor()?, Box::new(Lambert::new(Color::gray(0.8))?))
        .with(
            AxisAlignedBox::new(lbf, run)?,
            Box::new(Lambert::new(Color::RED)?),
        )
        .lit_by(LightSource::new(light, true)))
}
