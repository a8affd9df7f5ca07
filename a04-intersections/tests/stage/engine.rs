//! The engine hits the shapes of this stage as the lesson's list does, to the last bit.

mod compare;
mod edges;
mod scenes;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::fast::shapes;
use a04_intersections::{Geometry, Hit, Interval, Sphere, World};
use common::Color;

use super::support::Numbers;
use compare::compare;
use scenes::{Place, rays, world};

fn check(seed: u64, shape_count: usize, count: usize, place: Place) {
    let eye = place.point(Vector3::new(3.0, 2.0, 4.0));
    let lamp = place.point(Vector3::new(-1.0, 5.0, 2.0));
    let inside = place.point(Vector3::new(0.1, 0.2, -0.1));
    let sun = Vector3::new(-1.0, -2.0, 0.5).unit("sun").unwrap();
    let world = world(seed, shape_count, place);
    for (eye, lamp) in [(eye, lamp), (lamp, eye), (inside, inside)] {
        let rays = rays(seed + 1, count, place, eye, lamp, sun);
        let hits = compare(&world, shapes, &rays);
        assert!(hits > count, "{hits}");
    }
}

const HERE: Place = Place {
    middle: Vector3::new(0.0, 0.0, 0.0),
    size: 1.0,
};

#[test]
fn few_and_many_shapes_are_met_as_in_the_list() {
    for (seed, shapes) in [(10, 1), (20, 5), (30, 9), (40, 60), (50, 2_000)] {
        check(seed, shapes, 20_000 / shapes.max(10), HERE);
    }
}

#[test]
fn the_size_of_a_scene_does_not_matter_nor_its_place() {
    for (seed, size) in (0..).zip([1e-95, 1e-40, 1e-6, 1e6, 1e40, 1e95]) {
        check(seed, 100, 300, Place { size, ..HERE });
    }
    for (seed, far) in (0..).zip([1e3, 1e6, 1e9, 1e13]) {
        let middle = Vector3::new(far, -far, far);
        check(seed, 100, 300, Place { middle, ..HERE });
    }
}

/// A shape that the engine does not know.
#[derive(Debug)]
struct Unknown(Sphere);

impl Geometry for Unknown {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.0.hit(ray, within)
    }
}

/// Every third sphere is of a type that the engine does not know.
#[test]
fn unknown_shapes_are_met_as_in_the_list() {
    let mut world = World::new(Color::BLACK).unwrap();
    for i in 0..50 {
        let sphere = Sphere::new(Point3::new(f64::from(i), 0.0, 0.0), 0.6).unwrap();
        world = match i % 3 {
            0 => world.with(Unknown(sphere), i as usize),
            1 => world.with(Box::new(sphere) as Box<dyn Geometry>, i as usize),
            _ => world.with(sphere, i as usize),
        };
    }
    let eye = Point3::new(25.0, 5.0, 30.0);
    let mut numbers = Numbers::new(3);
    let mut aim = || Point3::new(25.0 + 26.0 * numbers.next(), 0.7 * numbers.next(), 0.0);
    let towards = |aim: Point3| Ray::new(eye, aim - eye).unwrap();
    let rays: Vec<_> = (0..20_000).map(|_| towards(aim())).collect();
    assert!(compare(&world, shapes, &rays) > 1000);
}
