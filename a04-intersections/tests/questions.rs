//! How many shapes a ray asks in a prepared world: those that it may meet, and
//! no others.
//!
//! Whom else it asks changes no picture, only the time it takes; so the
//! questions are counted.

use a02_math::{Lanes, Point3, Vector3};
use a03_rays_cameras::{Focus, Ray, RayPacket};
use a04_intersections::{AxisAlignedBox, Interval, Sphere, World};
use common::Color;
use measure::tally::{Work, counted};

/// Ten times ten small spheres, far apart, 20 ahead.
fn grid() -> World<()> {
    spheres(places(0.0), 0.1)
}

fn spheres(places: impl Iterator<Item = Point3>, r: f64) -> World<()> {
    let empty = World::new(Color::BLACK).unwrap();
    places.fold(empty, |world, place| {
        world.with(Sphere::new(place, r).unwrap(), ())
    })
}

/// The middles of the spheres, or places so far beside them.
fn places(beside: f64) -> impl Iterator<Item = Point3> {
    (0..100).map(move |i| {
        let [x, y] = [i % 10, i / 10].map(|n| f64::from(n) - 4.5 + beside);
        Point3::new(x, y, -20.0)
    })
}

const EYE: Point3 = Point3::new(1.0, 2.0, 0.0);
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

/// How many of some rays meet something, and how many questions they ask four at a
/// time; of each four those in `lanes`.
fn asked_by_fours(
    rays: impl Iterator<Item = Ray>,
    lanes: u32,
    met: impl Fn(&RayPacket, u32) -> u32 + Sync,
) -> Asked {
    let rays: Vec<_> = rays.collect();
    let (fours, _) = rays.as_chunks();
    let met = |four: &[Ray; 4]| met(&RayPacket::new(four.each_ref()), lanes).count_ones();
    let (met, tally) = counted(|| fours.iter().map(met).sum::<u32>()).unwrap();
    (met as usize, tally[Work::IntersectionTest])
}

fn hits_by_fours(world: &World<()>, rays: impl Iterator<Item = Ray>, lanes: u32) -> Asked {
    let search = world.search().expect("a prepared world");
    asked_by_fours(rays, lanes, |rays, lanes| {
        search.hit_together(rays, lanes).met
    })
}

/// The same, for whether they meet anything before `max`.
fn shadows_by_fours(
    world: &World<()>,
    rays: impl Iterator<Item = Ray>,
    max: f64,
    lanes: u32,
) -> Asked {
    let search = world.search().expect("a prepared world");
    asked_by_fours(rays, lanes, |rays, lanes| {
        search.is_hit_together(rays, Lanes::splat(max), lanes)
    })
}

/// Sixteen spheres: so few that four rays of no pencil ask all of them.
const FEW: usize = 16;

fn few() -> World<()> {
    spheres(places(0.0).take(FEW), 0.1)
}

/// The rays, but the last of each four goes where it belongs to no pencil.
fn with_strangers(rays: impl Iterator<Item = Ray>) -> impl Iterator<Item = Ray> {
    let aside = Vector3::new(0.6, 0.0, 0.8);
    let stranger = Ray::derived(Point3::new(0.0, 9.0, 0.0), aside);
    rays.enumerate()
        .map(move |(i, ray)| if i % 4 == 3 { stranger } else { ray })
}

/// If one of four is a stranger, three ask what they meet if it does not count, and
/// all four ask everything if it does.
#[test]
fn four_rays_from_the_eye_ask_the_spheres_that_they_meet() {
    for (focus, from_eye) in [(Focus::Point(EYE), true), (Focus::Direction(AHEAD), false)] {
        let world = few().prepared([focus]);
        let rays = |beside| {
            places(beside).take(FEW).map(move |place| {
                if from_eye {
                    Ray::new(EYE, place - EYE).unwrap()
                } else {
                    Ray::derived(place - AHEAD * 20.0, AHEAD)
                }
            })
        };
        assert_eq!(hits_by_fours(&world, rays(0.0), 0b1111), (16, 16));
        assert_eq!(hits_by_fours(&world, rays(0.5), 0b1111), (0, 0));
        let strangers = || with_strangers(rays(0.0));
        assert_eq!(hits_by_fours(&world, strangers(), 0b0111), (12, 12));
        assert_eq!(hits_by_fours(&world, strangers(), 0b1111), (12, 16 * 16));
    }
}

#[test]
fn four_shadow_rays_ask_what_lies_between_them_and_the_light() {
    let world = few().prepared([Focus::Point(EYE)]);
    // All start equally far from the light: behind the spheres, or before them.
    for (beside, way, expected) in [(0.0, 50.0, 16), (0.0, 15.0, 0), (0.5, 50.0, 0)] {
        let rays = || {
            places(beside).take(FEW).map(move |place| {
                let from = EYE + (place - EYE).normalized().unwrap() * way;
                Ray::new(from, EYE - from).unwrap()
            })
        };
        let all = (expected, expected as u64);
        assert_eq!(shadows_by_fours(&world, rays(), way, 0b1111), all);
        let three = (expected / 4 * 3, expected as u64 / 4 * 3);
        let strangers = || with_strangers(rays());
        assert_eq!(shadows_by_fours(&world, strangers(), way, 0b0111), three);
    }
}

#[test]
fn four_shadow_rays_to_the_sun_ask_what_lies_before_them() {
    let world = few().prepared([Focus::Direction(AHEAD)]);
    for (beside, depth, expected) in [(0.0, 10.0, 16), (0.0, -10.0, 0), (0.5, 10.0, 0)] {
        let rays = || {
            let places = places(beside).take(FEW);
            places.map(move |place| Ray::derived(place + AHEAD * depth, -AHEAD))
        };
        let endless = f64::INFINITY;
        let all = (expected, expected as u64);
        assert_eq!(shadows_by_fours(&world, rays(), endless, 0b1111), all);
        let three = (expected / 4 * 3, expected as u64 / 4 * 3);
        let strangers = || with_strangers(rays());
        assert_eq!(
            shadows_by_fours(&world, strangers(), endless, 0b0111),
            three
        );
    }
}

/// Three spheres and two boxes, all asked by rays of no pencil; the largest
/// coordinate is 1. Beyond 16384 times that a ray is of none.
#[test]
fn a_parallel_ray_from_very_far_asks_all() {
    let place = |i: usize| Point3::new([-0.9, -0.45, 0.0, 0.45, 0.9][i], 0.0, 0.0);
    let aside = Vector3::new(0.1, 0.1, 0.1);
    let aab = |i| AxisAlignedBox::new(place(i) - aside, place(i) + aside).unwrap();
    let world = spheres((0..3).map(place), 0.1)
        .with(aab(3), ())
        .with(aab(4), ())
        .prepared([Focus::Direction(AHEAD)]);
    let rays = |beside: f64, z: f64, way: Vector3| {
        let starts = (0..4).map(move |i| place(i) + Vector3::new(beside, 0.0, z));
        starts.map(move |start| Ray::derived(start, way))
    };
    for (distance, of_one) in [(16_000.0, 1), (17_000.0, 5)] {
        let seen = || rays(0.01, distance, AHEAD);
        assert_eq!(hits(&world, seen()), (4, 4 * of_one));
        assert_eq!(hits_by_fours(&world, seen(), 0b1111), (4, 4 * of_one));
        let shadow = || rays(0.2, -distance, -AHEAD);
        let asked_alone = asked(shadow(), |ray| world.is_hit(ray, Interval::AHEAD));
        assert_eq!(asked_alone, (0, 4 * (of_one - of_one % 5)));
        let endless = f64::INFINITY;
        let asked_together = shadows_by_fours(&world, shadow(), endless, 0b1111);
        assert_eq!(asked_together, asked_alone);
    }
}

/// Behind each sphere there is another, twice as far from the eye.
#[test]
fn what_lies_behind_a_hit_is_not_asked() {
    let behind = |place: Point3| EYE + (place - EYE) * 2.0;
    let both = places(0.0).chain(places(0.0).map(behind));
    let world = spheres(both, 0.1).prepared([Focus::Point(EYE)]);
    let rays = || places(0.0).map(|place| Ray::new(EYE, place - EYE).unwrap());
    assert_eq!(hits(&world, rays()), (100, 100));
    assert_eq!(hits_by_fours(&world, rays(), 0b1111), (100, 100));
}

/// Five spheres around one place fill every cell; beside those there is nothing.
#[test]
fn beside_all_shapes_nothing_is_asked() {
    let place = Point3::new(0.0, 0.0, -20.0);
    for focus in [Focus::Point(EYE), Focus::Direction(AHEAD)] {
        let world = spheres([place; 5].into_iter(), 1.0).prepared([focus]);
        let beside = [(3.0, 0.0), (-3.0, 0.0), (0.0, 3.0), (0.0, -3.0)];
        let rays = || {
            beside.into_iter().map(move |(x, y)| {
                let aim = place + Vector3::new(x, y, 0.0);
                match focus {
                    Focus::Point(eye) => Ray::new(eye, aim - eye).unwrap(),
                    Focus::Direction(way) => Ray::derived(aim - way * 20.0, way),
                }
            })
        };
        assert_eq!(hits(&world, rays()), (0, 0));
        assert_eq!(hits_by_fours(&world, rays(), 0b1111), (0, 0));
    }
}
