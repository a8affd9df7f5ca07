//! Random worlds, and rays through them.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Geometry, Plane, Sphere, Triangle, World};
use common::Color;

use crate::support::Numbers;

/// A scene of some size somewhere.
#[derive(Clone, Copy)]
pub struct Place {
    pub middle: Vector3,
    pub size: f64,
}

impl Place {
    pub fn point(self, at: Vector3) -> Point3 {
        Point3::ORIGIN + self.middle + at * self.size
    }
}

/// A world of `count` random shapes of all kinds, some of them twice and some
/// of them needles; the surface of each is its number.
pub fn world(seed: u64, count: usize, place: Place) -> World<usize> {
    let mut numbers = Numbers::new(seed);
    let mut world = World::new(Color::BLACK).unwrap();
    let small = 2.0 / libm::cbrt(count as f64);
    for i in 0..count {
        let at = numbers.vector();
        let (a, b) = (numbers.vector() * small, numbers.vector() * small);
        let [p, q, r] = [at, at + a, at + b].map(|corner| place.point(corner));
        let length = place.size * small * (1.1 + numbers.next()) / 2.0;
        let needle = place.point(at + a * 0.5 + b * 1e-9);
        let normals = [(); 3].map(|()| numbers.vector().as_normal());
        let shape: Box<dyn Geometry> = match i % 8 {
            // The same sphere twice: the first one counts.
            6 => {
                world = world.with(Sphere::new(p, length).unwrap(), count + i);
                Box::new(Sphere::new(p, length).unwrap())
            }
            0..3 => Box::new(Sphere::new(p, length).unwrap()),
            3 => Box::new(AxisAlignedBox::new(p, q).unwrap()),
            // Rounding may put the corners of a tiny triangle on a line.
            kind => match Triangle::new(p, q, if kind == 7 { needle } else { r }) {
                Ok(flat) if kind == 5 => Box::new(flat.with_normals(normals).unwrap()),
                Ok(flat) => Box::new(flat),
                Err(_) => continue,
            },
        };
        world = world.with(shape, i);
    }
    let down = place.point(Vector3::new(0.0, -1.2, 0.0));
    let floor = Plane::new(down, Normal3::new(0.0, 1.0, 0.1)).unwrap();
    world.with(floor, 2 * count)
}

/// Rays of all pencils, aimed at random places and at the rims of shapes, and
/// rays of none.
pub fn rays(
    seed: u64,
    count: usize,
    place: Place,
    eye: Point3,
    lamp: Point3,
    sun: Vector3,
) -> Vec<Ray> {
    let mut numbers = Numbers::new(seed);
    let ray = |from: Point3, way: Vector3| Ray::new(from, way).unwrap();
    let mut rays = Vec::new();
    for _ in 0..count {
        let a = place.point(numbers.vector());
        let b = place.point(numbers.vector() * 3.0);
        let c = place.point(numbers.vector());
        rays.extend([
            ray(eye, a - eye),
            ray(eye, c - eye),
            ray(a, lamp - a),
            ray(c, lamp - c),
            ray(b, -sun),
            ray(a, sun),
            ray(b, a - b),
            ray(a, numbers.vector()),
            ray(a, Vector3::new(0.0, 0.0, 1.0)),
            ray(a, Vector3::new(-1.0, -0.0, -0.0)),
        ]);
    }
    rays
}
