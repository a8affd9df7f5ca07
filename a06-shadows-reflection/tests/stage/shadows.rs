//! Shadows: where they fall, where they must not, and at which sizes.

mod lights;
mod objects;
mod sizes;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Plane, Sphere};
use a05_lighting::{Lambert, Light, PointLight};
use a06_shadows_reflection::{LightSource, RecursiveTracer, ShadowedWorld, Surface};
use common::Color;

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
const AMBIENT: Color = Color::gray(0.25);
const LIT: Color = Color::gray(1.25);

fn white() -> Box<dyn Surface> {
    Box::new(Lambert::new(Color::WHITE).unwrap())
}

fn plane(y: f64) -> Plane {
    Plane::new(Point3::new(0.0, y, 0.0), UP.as_normal()).unwrap()
}

fn sphere(x: f64, y: f64, z: f64, r: f64) -> Sphere {
    Sphere::new(Point3::new(x, y, z), r).unwrap()
}

fn point_light(x: f64, y: f64, z: f64) -> PointLight {
    PointLight::new(Color::WHITE, Point3::new(x, y, z)).unwrap()
}

/// The white floor y = 0 in a little ambient light.
fn floor() -> ShadowedWorld {
    ShadowedWorld::empty(Color::BLACK, AMBIENT)
        .unwrap()
        .with(plane(0.0), white())
}

fn lamp(light: impl Light + 'static) -> LightSource {
    LightSource::new(light, true)
}

/// The colour of the origin, seen from so far aside that no object above it is in
/// the way.
fn seen(world: &ShadowedWorld) -> Color {
    let eye = Point3::new(-8.0, 1.0, 0.0);
    let ray = Ray::new(eye, Point3::ORIGIN - eye).unwrap();
    RecursiveTracer::new(world).trace(&ray, 1)
}
