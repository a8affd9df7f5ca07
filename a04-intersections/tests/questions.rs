//! How many shapes a ray asks in a prepared world: those that it may meet, and
//! no others.
//!
//! Whom else it asks changes no picture, only the time it takes; so the
//! questions are counted.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{Focus, Ray};
use a04_intersections::{Interval, Sphere, World};
use common::Color;
use common::tally::{Work, counted};

/// Ten times ten small spheres, far apart, 20 ahead.
fn grid() -> World<()> {
    let mut world = World::new(Color::BLACK).unwrap();
    for place in places(0.0) {
        world = world.with(Sphere::new(place, 0.1).unwrap(), ());
    }
    world
}

/// The middles of the spheres, or places so far beside them.
fn places(beside: f64) -> impl Iterator<Item = Point3> {
    (0..100).map(move |i| {
        let [x, y] = [i % 10, i / 10].map(|n| f64::from(n) - 4.5 + beside);
        Point3::new(x, y, -20.0)
    })
}

const EYE: Point3 = Point3::ORIGIN;
const AHEAD: Vector3 = Vector3::new(0.0, 0.0, -1.0);

type Asked = (usize, u64);

/// How many rays meet something, and how many questions they ask.
fn asked(rays: impl Iterator<Item = Ray> + Send, is_met: impl Fn(&Ray) -> bool + Send) -> Asked {
    let (met, tally) = counted(|| rays.filter(is_met).count()).unwrap();
    (met, tally[Work::IntersectionTest])
}

fn hits(world: &World<()>, rays: impl Iterator<Item = Ray> + Send) -> Asked {
    asked(rays, |ray| world.hit(ray, Interval::AHEAD).is_some())
}

#[test]
fn a_ray_from_the_eye_asks_the_sphere_that_it_meets() {
    let world = grid().prepared([Focus::Point(EYE)]);
    let to = |place: Point3| Ray::new(EYE, place - EYE).unwrap();
    assert_eq!(hits(&world, places(0.0).map(to)), (100, 100));
    assert_eq!(hits(&world, places(0.5).map(to)), (0, 0));
}

#[test]
fn a_parallel_ray_asks_the_sphere_that_it_meets() {
    let world = grid().prepared([Focus::Direction(AHEAD)]);
    let above = |place: Point3| Ray::derived(place - AHEAD * 20.0, AHEAD);
    assert_eq!(hits(&world, places(0.0).map(above)), (100, 100));
    assert_eq!(hits(&world, places(0.5).map(above)), (0, 0));
}

/// From behind the spheres, from before them, and beside them.
#[test]
fn a_shadow_ray_asks_what_lies_between_it_and_the_light() {
    let world = grid().prepared([Focus::Point(EYE)]);
    let shadow = |beside: f64, times: f64| {
        let rays = places(beside).map(move |place| {
            let from = EYE + (place - EYE) * times;
            Ray::new(from, EYE - from).unwrap()
        });
        asked(rays, |ray| {
            let to_light = (ray.origin() - EYE).magnitude();
            world.is_hit(ray, Interval::before(to_light))
        })
    };
    assert_eq!(shadow(0.0, 1.5), (100, 100));
    assert_eq!(shadow(0.0, 0.5), (0, 0));
    assert_eq!(shadow(0.5, 1.5), (0, 0));
}

/// The same along a direction, without end.
#[test]
fn a_shadow_ray_to_the_sun_asks_what_lies_before_it() {
    let world = grid().prepared([Focus::Direction(AHEAD)]);
    let shadow = |beside: f64, depth: f64| {
        let rays = places(beside).map(move |place| Ray::derived(place + AHEAD * depth, -AHEAD));
        asked(rays, |ray| world.is_hit(ray, Interval::AHEAD))
    };
    assert_eq!(shadow(0.0, 10.0), (100, 100));
    assert_eq!(shadow(0.0, -10.0), (0, 0));
    assert_eq!(shadow(0.5, 10.0), (0, 0));
}

/// Groups of four, far from one another, are blocks of the tree.
#[test]
fn other_rays_ask_the_group_that_they_meet() {
    let mut world = World::new(Color::BLACK).unwrap();
    let groups = || (0..25).map(|i| [i % 5, i / 5].map(|n| 1000.0 * f64::from(n)));
    for [x, y] in groups() {
        for (dx, dy) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
            let place = Point3::new(x + dx, y + dy, 0.0);
            world = world.with(Sphere::new(place, 0.3).unwrap(), ());
        }
    }
    let world = world.prepared([]);
    let towards = |beside: f64| {
        groups().map(move |[x, y]| Ray::derived(Point3::new(x + beside, y, 50.0), AHEAD))
    };
    assert_eq!(hits(&world, towards(0.0)), (25, 4 * 25));
    assert_eq!(hits(&world, towards(500.0)), (0, 0));
}
