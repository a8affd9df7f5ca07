//! The world: the object that is seen among several, and its side.

use a02_math::{Direction, Normal3, Point3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Geometry, Hit, Interval, Sphere, World};
use common::Color;
use testing::assert_refused;

use crate::test_shapes::{point, random_ray, random_shapes, ray};

fn empty<S>() -> World<S> {
    World::new(Color::BLUE).unwrap()
}

/// Each shape stands twice in the list: of shapes at the same place, the first counts. The
/// interval bounds the search, so that an object before it hides nothing. Seen from behind
/// its face, both normals turn, also where the interpolated one looks to the eye already.
#[test]
fn a_world_is_hit_where_the_nearest_of_its_shapes_is() {
    let (mut world, mut hits, mut leaning) = (empty(), 0, 0);
    for n in 0..6000 {
        if n % 50 == 0 {
            let shapes = (0..2).flat_map(|_| random_shapes(n.into())).enumerate();
            world = shapes.fold(empty(), |world, (turn, shape)| world.with(shape, turn));
        }
        let (random, ray) = (PixelRandom::new(3, n, 0), random_ray(n));
        let [min, length] = [4.0, 24.0].map(|width| width * random.uniform(width as u64));
        let within = Interval {
            min,
            max: min + length,
        };
        let objects = world.objects();
        let found = objects.filter_map(|(shape, turn)| Some((shape.hit(&ray, within)?, *turn)));
        let nearest = found.min_by(|(a, _), (b, _)| a.t.total_cmp(&b.t));
        let seen = nearest.map(|(hit, turn)| {
            let [normal, geometric_normal] =
                [hit.normal, hit.geometric_normal].map(|n| n.dot(ray.direction()));
            leaning += u32::from(normal * geometric_normal < 0.0);
            let side = if geometric_normal > 0.0 { -1.0 } else { 1.0 };
            let (normal, geometric_normal) = (hit.normal * side, hit.geometric_normal * side);
            (
                Hit {
                    normal,
                    geometric_normal,
                    ..hit
                },
                turn,
            )
        });
        let hit = world.hit(&ray, within).map(|(hit, turn)| (hit, *turn));
        assert_eq!(hit, seen);
        assert_eq!(world.is_hit(&ray, within), seen.is_some());
        hits += u32::from(hit.is_some());
    }
    println!("{hits} hits, {leaning} leaning");
    assert!(
        (1000..5000).contains(&hits) && leaning > 5,
        "{hits} hits, {leaning} leaning"
    );
}

/// A ray along a sphere faces neither side: its normal stays.
#[test]
fn a_touched_sphere_shows_its_outer_side() {
    for y in [1.0, -1.0] {
        let touched = Sphere::new(point([0.0, -y, -5.0]), 1.0).unwrap();
        let world = empty().with(touched, ());
        let (hit, ()) = world
            .hit(&ray([0.0; 3], [0.0, 0.0, -1.0]), Interval::AHEAD)
            .unwrap();
        let expected = Hit::new(5.0, Normal3::new(0.0, y, 0.0));
        assert_eq!(hit, expected.with_scale(1.0));
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
    let around = Sphere::new(Point3::ORIGIN, 3.0).unwrap();
    let world = empty().with(around, ()).with(Untested, ());
    assert!(world.is_hit(&ray([0.0; 3], [0.0, 0.0, -1.0]), Interval::AHEAD));
}

#[test]
fn where_nothing_is_hit_the_background_is_seen() {
    assert_eq!(empty().color_for(&random_ray(0)), Color::BLUE);
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
