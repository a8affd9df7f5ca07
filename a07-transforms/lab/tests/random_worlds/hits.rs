//! The engine hits the shapes of stage 4 as the lesson's list does, to the last bit.

mod edges;
mod nodes;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::kinds::KINDS;
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle, World};
use a04_lab::support::Numbers;
use common::Color;

use crate::same_hits::compare;

/// A scene of some size somewhere.
#[derive(Clone, Copy)]
struct Place {
    middle: Vector3,
    size: f64,
}

const HERE: Place = Place {
    middle: Vector3::new(0.0, 0.0, 0.0),
    size: 1.0,
};

/// A shape that the engine does not know.
#[derive(Debug)]
struct Unknown(Sphere);

impl Geometry for Unknown {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.0.hit(ray, within)
    }
}

impl Place {
    fn point(self, at: Vector3) -> Point3 {
        Point3::ORIGIN + self.middle + at * self.size
    }

    /// A world of `count` random shapes of all kinds, some of them twice, some of them needles
    /// and some of a type that the engine does not know; the surface of each is its number.
    fn world(self, seed: u64, count: usize) -> World<usize> {
        let mut numbers = Numbers::new(seed, 0);
        let mut world = World::new(Color::BLACK).unwrap();
        let small = 2.0 / libm::cbrt(count as f64);
        for i in 0..count {
            let at = numbers.triple(-1.0, 1.0);
            let [a, b] = [(); 2].map(|()| numbers.triple(-small, small));
            let needle = at + a * 0.5 + b * 1e-9;
            let [p, q, r, needle] = [at, at + a, at + b, needle].map(|at| self.point(at));
            let length = self.size * small * numbers.between(0.05, 1.05);
            let sphere = Sphere::new(p, length).unwrap();
            let normals = [(); 3].map(|()| numbers.triple(-1.0, 1.0).as_normal());
            let shape: Box<dyn Geometry> = match i % 9 {
                0..3 => Box::new(sphere),
                3 => Box::new(AxisAlignedBox::new(p, q).unwrap()),
                // The same sphere twice: the first one counts.
                4 => {
                    world = world.with(sphere, count + i);
                    Box::new(sphere)
                }
                5 => Box::new(Unknown(sphere)),
                // Rounding may put the corners of a tiny triangle on a line.
                kind => match Triangle::new(p, q, if kind == 6 { needle } else { r }) {
                    Ok(flat) if kind == 7 => Box::new(flat.with_normals(normals).unwrap()),
                    Ok(flat) => Box::new(flat),
                    Err(_) => continue,
                },
            };
            world = world.with(shape, i);
        }
        let down = self.point(Vector3::new(0.0, -1.2, 0.0));
        let floor = Plane::new(down, Normal3::new(0.0, 1.0, 0.1)).unwrap();
        world.with(floor, 2 * count)
    }

    /// Ten rays, from an eye and to a lamp, parallel ones, along axes, and in all directions.
    fn rays(self, numbers: &mut Numbers, eye: Point3, lamp: Point3) -> [Ray; 10] {
        let sun = Vector3::new(-1.0, -2.0, 0.5);
        let [a, b, c] = [1.0, 3.0, 1.0].map(|reach| self.point(numbers.triple(-reach, reach)));
        [
            (eye, a - eye),
            (eye, c - eye),
            (a, lamp - a),
            (c, lamp - c),
            (b, -sun),
            (a, sun),
            (b, a - b),
            (a, numbers.triple(-1.0, 1.0)),
            (a, Vector3::new(0.0, 0.0, 1.0)),
            (a, Vector3::new(-1.0, -0.0, -0.0)),
        ]
        .map(|(from, way)| Ray::new(from, way).unwrap())
    }

    fn check(self, seed: u64, shape_count: usize, count: usize) {
        let [eye, lamp, inside] = [[3.0, 2.0, 4.0], [-1.0, 5.0, 2.0], [0.1, 0.2, -0.1]]
            .map(|at| self.point(Vector3::from_glam(at.into())));
        let world = self.world(seed, shape_count);
        let mut numbers = Numbers::new(seed + 1, 0);
        for (eye, lamp) in [(eye, lamp), (lamp, eye), (inside, inside)] {
            let rays = (0..count).flat_map(|_| self.rays(&mut numbers, eye, lamp));
            let hits = compare(&world, KINDS, &rays.collect::<Vec<_>>());
            assert!(hits > count, "{hits}");
        }
    }
}

#[test]
fn few_and_many_shapes_are_met_as_in_the_list() {
    for (seed, shapes) in [(10, 1), (20, 6), (30, 9), (40, 60), (50, 2_000)] {
        HERE.check(seed, shapes, 25_000 / shapes.max(10));
    }
}

#[test]
fn the_size_of_a_scene_does_not_matter_nor_its_place() {
    for (seed, size) in (0..).zip([1e-95, 1e-40, 1e-6, 1e6, 1e40, 1e95]) {
        Place { size, ..HERE }.check(seed, 100, 300);
    }
    for (seed, far) in (0..).zip([1e3, 1e6, 1e9, 1e13]) {
        let middle = Vector3::new(far, -far, far);
        Place { middle, ..HERE }.check(seed, 100, 300);
    }
}
