//! Random worlds, and rays to ask them with.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Interval, Plane, Sphere, Triangle, World};
use common::Color;

/// Random numbers in a row, each from -1 to 1.
pub struct Numbers(PixelRandom, u64);

impl Numbers {
    pub fn new(seed: u64) -> Self {
        Self(PixelRandom::new(seed, 0, 0), 0)
    }

    pub fn next(&mut self) -> f64 {
        self.1 += 1;
        2.0 * self.0.uniform(self.1) - 1.0
    }

    pub fn vector(&mut self) -> Vector3 {
        Vector3::new(self.next(), self.next(), self.next())
    }
}

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
        let corners = [at, at + a, at + b].map(|corner| place.point(corner));
        let [p, q, r] = corners;
        let length = place.size * small * (1.1 + numbers.next()) / 2.0;
        // Rounding may put the corners of a tiny triangle on a line.
        let triangle = |third: Point3| Triangle::new(p, q, third).ok();
        let flat = match i % 8 {
            0..3 => {
                world = world.with(Sphere::new(p, length).unwrap(), i);
                None
            }
            3 => {
                world = world.with(AxisAlignedBox::new(p, q).unwrap(), i);
                None
            }
            4 => triangle(r),
            5 => {
                let normals = [numbers.vector(), numbers.vector(), numbers.vector()];
                let normals = normals.map(Vector3::as_normal);
                triangle(r).and_then(|flat| flat.with_normals(normals).ok())
            }
            6 => {
                // The same sphere twice: the first one counts.
                let sphere = Sphere::new(p, length).unwrap();
                world = world.with(sphere, i).with(sphere, count + i);
                None
            }
            // A needle.
            _ => triangle(place.point(at + a * 0.5 + b * 1e-9)),
        };
        if let Some(triangle) = flat {
            world = world.with(triangle, i);
        }
    }
    let down = place.point(Vector3::new(0.0, -1.2, 0.0));
    world.with(
        Plane::new(down, Normal3::new(0.0, 1.0, 0.1)).unwrap(),
        2 * count,
    )
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
) -> Vec<(Ray, Interval)> {
    let mut numbers = Numbers::new(seed);
    let mut rays = Vec::new();
    for _ in 0..count {
        let (a, b) = (
            place.point(numbers.vector()),
            place.point(numbers.vector() * 3.0),
        );
        let reach = place.size * (1.0 + numbers.next());
        let seen = Ray::new(eye, a - eye).unwrap();
        let to_lamp = lamp - a;
        let way = to_lamp.magnitude();
        rays.extend([
            (seen, Interval::AHEAD),
            (
                seen,
                Interval {
                    min: reach / 2.0,
                    max: 3.0 * reach,
                },
            ),
            (
                Ray::new(a, to_lamp).unwrap(),
                Interval::before(way * (1.0 - 1e-7)),
            ),
            (Ray::new(a, to_lamp).unwrap(), Interval::before(way / 2.0)),
            (Ray::new(b, -sun).unwrap(), Interval::AHEAD),
            (Ray::new(a, sun).unwrap(), Interval::AHEAD),
            (Ray::new(b, a - b).unwrap(), Interval::AHEAD),
            (
                Ray::new(a, numbers.vector()).unwrap(),
                Interval::before(reach),
            ),
            (
                Ray::new(a, Vector3::new(0.0, 0.0, 1.0)).unwrap(),
                Interval::AHEAD,
            ),
            (
                Ray::new(a, Vector3::new(-1.0, -0.0, -0.0)).unwrap(),
                Interval::AHEAD,
            ),
        ]);
    }
    rays
}
