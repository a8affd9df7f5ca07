//! The world: the object that is seen among several, and its side.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle, World};
use common::Color;

const AHEAD: Vector3 = Vector3::new(0.0, 0.0, -1.0);
const TOWARDS: Normal3 = Normal3::new(0.0, 0.0, 1.0);

fn empty<S>() -> World<S> {
    World::new(Color::BLUE).unwrap()
}

/// The unit sphere whose front is `distance` ahead of the origin.
fn sphere(distance: f64) -> Sphere {
    Sphere::new(Point3::new(0.0, 0.0, -distance - 1.0), 1.0).unwrap()
}

fn plane(z: f64) -> Plane {
    Plane::new(Point3::new(0.0, 0.0, z), TOWARDS).unwrap()
}

fn ahead() -> Ray {
    Ray::new(Point3::ORIGIN, AHEAD).unwrap()
}

#[test]
fn an_interval_is_open_and_holds_no_nan() {
    let interval = Interval {
        min: -1.0,
        max: 2.0,
    };
    assert!(interval.contains((-1_f64).next_up()) && interval.contains(2_f64.next_down()));
    assert!(!interval.contains(-1.0) && !interval.contains(2.0));
    assert!(!interval.contains(f64::NAN));
    assert!(Interval::AHEAD.contains(5e-324) && Interval::AHEAD.contains(f64::MAX));
    for outside in [0.0, -0.0, -1.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        assert!(!Interval::AHEAD.contains(outside));
    }
    assert_eq!(Interval::before(3.0), Interval { min: 0.0, max: 3.0 });
}

#[test]
fn the_nearest_object_is_seen_in_whatever_order_they_are_listed() {
    let distances = [2.0, 5.0, 9.0];
    for order in [
        [0, 1, 2],
        [0, 2, 1],
        [1, 0, 2],
        [1, 2, 0],
        [2, 0, 1],
        [2, 1, 0],
    ] {
        let world = order
            .into_iter()
            .fold(empty(), |world, n| world.with(sphere(distances[n]), n));
        for (min, nearest) in [(0.0, 0), (4.0, 1), (7.0, 2)] {
            let within = Interval {
                min,
                max: f64::INFINITY,
            };
            let (hit, n) = world.hit(&ahead(), within).unwrap();
            assert_eq!((hit, *n), (Hit::new(distances[nearest], TOWARDS), nearest));
        }
    }
}

#[test]
fn of_objects_at_the_same_place_the_first_is_seen() {
    let world = empty()
        .with(plane(-9.0), Color::GREEN)
        .with(plane(-4.0), Color::RED)
        .with(sphere(4.0), Color::YELLOW)
        .with(plane(-4.0), Color::WHITE);
    assert_eq!(world.color_for(&ahead()), Color::RED);
}

/// The interval bounds the search: asked of the nearest hit afterwards, it
/// would let the nearer object hide the farther one.
#[test]
fn what_lies_outside_of_the_interval_hides_nothing() {
    let world = empty()
        .with(plane(-1.0), 1)
        .with(plane(-2.0), 2)
        .with(plane(-3.0), 3);
    let met = |min, max| {
        let hit = world.hit(&ahead(), Interval { min, max });
        hit.map(|(hit, surface)| (hit.t, *surface))
    };
    assert_eq!(met(1.0, 9.0), Some((2.0, 2)));
    assert_eq!(met(2.0, 3.0), None);
    assert_eq!(met(-9.0, 1.0), None);
    assert_eq!(met(3.0, 9.0), None);
    assert_eq!(met(0.0, 2.0), Some((1.0, 1)));
}

#[test]
fn is_hit_agrees_with_hit() {
    let (lbf, run) = (Point3::new(1.0, 1.0, -5.0), Point3::new(3.0, 2.0, -4.0));
    let corners = [(-3.0, 0.0), (-1.0, 0.0), (-2.0, 3.0)].map(|(x, y)| Point3::new(x, y, -3.0));
    let [a, b, c] = corners;
    let world = empty()
        .with(sphere(2.0), ())
        .with(AxisAlignedBox::new(lbf, run).unwrap(), ())
        .with(Triangle::new(a, b, c).unwrap(), ())
        .with(plane(-6.0), ());
    let mut counts = [0, 0];
    for n in 0..4000 {
        let random = PixelRandom::new(3, n, 0);
        let [x, y] = [0, 1].map(|i| random.uniform(i) * 3.0 - 1.5);
        let ray = Ray::new(Point3::ORIGIN, Vector3::new(x, y, -1.0)).unwrap();
        let min = random.uniform(2) * 4.0;
        let within = Interval {
            min,
            max: min + random.uniform(3) * 12.0,
        };
        let hit = world.hit(&ray, within);
        assert_eq!(world.is_hit(&ray, within), hit.is_some());
        assert!(hit.is_none_or(|(hit, ())| within.contains(hit.t)));
        counts[usize::from(hit.is_some())] += 1;
    }
    assert!(
        counts.iter().all(|count| *count > 500),
        "hits and misses: {counts:?}"
    );
}

#[test]
fn normals_face_whoever_looks() {
    // From within a sphere, and from behind a plane.
    let around = Sphere::new(Point3::ORIGIN, 3.0).unwrap();
    let world = empty().with(around, ());
    let (hit, ()) = world.hit(&ahead(), Interval::AHEAD).unwrap();
    assert_eq!(hit, Hit::new(3.0, TOWARDS));

    let turned = Plane::new(Point3::new(0.0, 0.0, -3.0), -TOWARDS).unwrap();
    let world = empty().with(turned, ());
    let (hit, ()) = world.hit(&ahead(), Interval::AHEAD).unwrap();
    assert_eq!(hit, Hit::new(3.0, TOWARDS));
    // From the side that it faces already, nothing is turned.
    let back = Ray::new(Point3::new(0.0, 0.0, -5.0), -AHEAD).unwrap();
    let (hit, ()) = world.hit(&back, Interval::AHEAD).unwrap();
    assert_eq!(hit, Hit::new(2.0, -TOWARDS));
}

/// The interpolated normal turns together with the face, also where it leans
/// over so far that it looks away from the eye while the face does not.
#[test]
fn interpolated_normals_turn_with_the_face() {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (0.0, 1.0)].map(|(x, y)| Point3::new(x, y, 0.0));
    let [a, b, c] = corners;
    let leaning = Normal3::new(0.8, 0.0, 0.6);
    let triangle = Triangle::new(a, b, c).unwrap().with_normals([leaning; 3]);
    let world = empty().with(triangle.unwrap(), ());
    let seen = |o: [f64; 3], side: Normal3| {
        let o = Point3::from_glam(o.into());
        let ray = Ray::new(o, Point3::ORIGIN - o).unwrap();
        let (hit, ()) = world.hit(&ray, Interval::AHEAD).unwrap();
        assert_eq!(hit.face, side);
        assert!(hit.face.dot(ray.direction()) <= 0.0);
        hit.normal
    };
    let unit = leaning.normalized().unwrap();
    assert_eq!(seen([0.0, 0.0, 5.0], TOWARDS), unit);
    assert_eq!(seen([-5.0, 0.0, 1.0], TOWARDS), unit, "n looks away");
    assert_eq!(seen([0.0, 0.0, -5.0], -TOWARDS), -unit);
    assert_eq!(seen([5.0, 0.0, -1.0], -TOWARDS), -unit);
}

#[test]
fn where_nothing_is_hit_the_background_is_seen() {
    let world = empty();
    assert_eq!(world.background(), Color::BLUE);
    assert_eq!(world.color_for(&ahead()), Color::BLUE);
    assert!(world.hit(&ahead(), Interval::AHEAD).is_none());
    assert!(!world.is_hit(&ahead(), Interval::AHEAD));
    let behind = world.with(plane(5.0), Color::RED);
    assert_eq!(behind.color_for(&ahead()), Color::BLUE);
    assert_eq!(
        behind.with(plane(-5.0), Color::RED).color_for(&ahead()),
        Color::RED
    );
}

#[test]
fn a_world_tells_how_many_objects_it_has() {
    let (none, two) = (empty(), empty().with(plane(1.0), ()).with(plane(2.0), ()));
    for (world, objects) in [(none, 0), (two, 2)] {
        assert_eq!((world.len(), world.is_empty()), (objects, objects == 0));
        assert_eq!(world.objects().count(), objects);
        assert_eq!(world.into_objects().len(), objects);
    }
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
    let world = empty().with(plane(-1.0), ()).with(Untested, ());
    assert!(world.is_hit(&ahead(), Interval::AHEAD));
}

/// A ray along a sphere faces neither side: its normal stays.
#[test]
fn where_a_ray_just_touches_the_normal_points_outwards() {
    let y = Vector3::new(0.0, 1.0, 0.0);
    let world = empty().with(sphere(4.0), ());
    for up in [y, -y] {
        let ray = Ray::derived(Point3::ORIGIN + up, AHEAD);
        let (hit, ()) = world.hit(&ray, Interval::AHEAD).unwrap();
        assert_eq!(hit, Hit::new(5.0, up.as_normal()));
    }
}

#[test]
fn backgrounds_of_no_numbers_are_refused() {
    for bad in [f64::NAN, f64::INFINITY, -0.5, 1e51] {
        let background = Color::new(0.0, 0.0, bad);
        let said = World::<Color>::new(background).unwrap_err().to_string();
        assert!(said.starts_with("background is"), "{said}");
        assert!(said.contains("channels from 0 to 1e50"), "{said}");
    }
    assert!(
        World::<Color>::new(Color::gray(7.0)).is_ok(),
        "brighter than white"
    );
}
