//! The world: the object that is seen among several, and its side.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Geometry, Hit, Interval, Plane, Sphere, Triangle, World};
use common::Color;
use testing::assert_refused;

use super::support::{point, random_ray, random_shape, ray};

const TOWARDS: Normal3 = Normal3::new(0.0, 0.0, 1.0);
const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

fn empty<S>() -> World<S> {
    World::new(Color::BLUE).unwrap()
}

fn plane(z: f64, n: Normal3) -> Plane {
    Plane::new(point([0.0, 0.0, z]), n).unwrap()
}

fn ahead() -> Ray {
    ray([0.0; 3], [0.0, 0.0, -1.0])
}

/// Each shape stands twice in the list: of shapes at the same place, the first counts. The
/// interval bounds the search, so that an object before it hides nothing.
#[test]
fn a_world_is_hit_where_the_nearest_of_its_shapes_is() {
    let mut hits = 0;
    for n in 0..3000 {
        let (random, ray) = (PixelRandom::new(3, n, 0), random_ray(n));
        let [min, length] = [4.0, 24.0].map(|width| width * random.uniform(width as u64));
        let within = Interval {
            min,
            max: min + length,
        };
        let count = n % 12;
        let shape = |turn| random_shape(10 * n + turn % count.div_ceil(2));
        let found = (0..count).filter_map(|turn| Some((shape(turn).hit(&ray, within)?.t, turn)));
        let nearest = found.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let world = (0..count).fold(empty(), |world, turn| world.with(shape(turn), turn));
        let hit = world.hit(&ray, within).map(|(hit, turn)| (hit.t, *turn));
        assert_eq!(hit, nearest);
        assert_eq!(world.is_hit(&ray, within), nearest.is_some());
        hits += u32::from(hit.is_some());
    }
    assert!((500..2500).contains(&hits), "{hits} hits");
}

/// A shape that no ray may be tested against.
#[derive(Debug)]
struct Untested;

impl Geometry for Untested {
    fn hit(&self, _: &Ray, _: Interval) -> Option<Hit> {
        panic!("a search for any object goes on behind the first");
    }
}

#[test]
fn a_search_for_any_object_ends_at_the_first() {
    let world = empty().with(plane(-1.0, TOWARDS), ()).with(Untested, ());
    assert!(world.is_hit(&ahead(), Interval::AHEAD));
}

/// Also from within a sphere and from behind a plane. A ray along a sphere faces neither
/// side: its normal stays.
#[test]
fn normals_point_to_the_side_of_the_eye() {
    let hit = |world: World<()>, ray: Ray| world.hit(&ray, Interval::AHEAD).unwrap().0;
    let back = ray([0.0, 0.0, -5.0], [0.0, 0.0, 1.0]);
    let around = Sphere::new(Point3::ORIGIN, 3.0).unwrap();
    assert_eq!(
        hit(empty().with(around, ()), ahead()),
        Hit::new(3.0, TOWARDS)
    );
    for n in [TOWARDS, -TOWARDS] {
        let world = || empty().with(plane(-3.0, n), ());
        assert_eq!(hit(world(), ahead()), Hit::new(3.0, TOWARDS));
        assert_eq!(hit(world(), back), Hit::new(2.0, -TOWARDS));
    }
    for up in [UP, -UP] {
        let touched = Sphere::new(Point3::new(0.0, 0.0, -5.0) - up, 1.0).unwrap();
        let world = empty().with(touched, ());
        assert_eq!(hit(world, ahead()), Hit::new(5.0, up.as_normal()));
    }
}

/// The interpolated normal turns together with the face, also where it leans
/// over so far that it looks away from the eye while the face does not.
#[test]
fn interpolated_normals_turn_with_the_face() {
    let [a, b, c] = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]].map(point);
    let leaning = Normal3::new(0.8, 0.0, 0.6);
    let triangle = Triangle::new(a, b, c).unwrap().with_normals([leaning; 3]);
    let world = empty().with(triangle.unwrap(), ());
    let unit = leaning.normalized().unwrap();
    for (o, face, normal) in [
        ([0.0, 0.0, 5.0], TOWARDS, unit),
        // The normal looks away.
        ([-5.0, 0.0, 1.0], TOWARDS, unit),
        ([0.0, 0.0, -5.0], -TOWARDS, -unit),
        ([5.0, 0.0, -1.0], -TOWARDS, -unit),
    ] {
        let ray = Ray::new(point(o), Point3::ORIGIN - point(o)).unwrap();
        let (hit, ()) = world.hit(&ray, Interval::AHEAD).unwrap();
        assert_eq!((hit.face, hit.normal), (face, normal));
        assert!(hit.face.dot(ray.direction()) <= 0.0);
    }
}

#[test]
fn where_nothing_is_hit_the_background_is_seen() {
    assert_eq!(empty().color_for(&ahead()), Color::BLUE);
    let behind = empty().with(plane(5.0, TOWARDS), Color::RED);
    assert_eq!(behind.color_for(&ahead()), Color::BLUE);
    let before = behind.with(plane(-5.0, TOWARDS), Color::RED);
    assert_eq!(before.color_for(&ahead()), Color::RED);
}

#[test]
fn backgrounds_of_no_numbers_are_refused() {
    for bad in [f64::NAN, f64::INFINITY, -0.5, 1e51] {
        let world = World::<Color>::new(Color::new(0.0, 0.0, bad));
        assert_refused(world, "background is", "channels from 0 to 1e50");
    }
    let brighter_than_white = World::<Color>::new(Color::gray(7.0));
    assert!(brighter_than_white.is_ok());
}
