//! Nodes: objects that are moved by moving the ray.

mod children;
mod shadows;
mod shapes;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Geometry, Hit, Interval, Sphere};
use a07_transforms::Transform;

const AHEAD: Vector3 = Vector3::new(0.0, 0.0, -1.0);

fn unit_sphere() -> Sphere {
    Sphere::new(Point3::ORIGIN, 1.0).unwrap()
}

fn translated(x: f64, y: f64, z: f64) -> Transform {
    let to = Point3::new(x, y, z);
    Transform::IDENTITY.translate(to).unwrap()
}

fn scaled(x: f64, y: f64, z: f64) -> Transform {
    Transform::IDENTITY.scale(x, y, z).unwrap()
}

fn ahead() -> Ray {
    Ray::new(Point3::ORIGIN, AHEAD).unwrap()
}

fn hit(geometry: &impl Geometry, ray: &Ray) -> Option<Hit> {
    geometry.hit(ray, Interval::AHEAD)
}

/// Rays from a distance of some 10 towards and past the origin.
fn rays(count: u32) -> impl Iterator<Item = Ray> {
    (0..count).map(|n| {
        let random = PixelRandom::new(17, n, 0);
        let vector = |first: u64, width: f64| {
            let three = [0, 1, 2].map(|i| width * (random.uniform(first + i) - 0.5));
            Vector3::from_glam(three.into())
        };
        let out = vector(0, 1.0).normalized().unwrap();
        let eye = Point3::ORIGIN + out * 10.0;
        let aim = Point3::ORIGIN + vector(3, 8.0);
        Ray::new(eye, aim - eye).unwrap()
    })
}
