//! A prepared world knows where something narrow may hide between the rays of a
//! picture.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{Focus, Ray};
use a04_intersections::{Geometry, Hit, Interval, Plane, Sphere, World};
use common::Color;

const EYE: Point3 = Point3::new(1.0, 2.0, 3.0);
const AHEAD: Vector3 = Vector3::new(0.0, 0.0, -1.0);

/// Rays from the eye to the corners of a square of side 4 that is 10 ahead, whose
/// middle is so far to the right and up.
fn square([right, up]: [f64; 2]) -> [Ray; 4] {
    [(-2.0, 2.0), (2.0, 2.0), (-2.0, -2.0), (2.0, -2.0)].map(|(x, y)| {
        let to = Vector3::new(right + x, up + y, -10.0);
        Ray::new(EYE, to).unwrap()
    })
}

/// Its bounds begin 10 ahead, and there they are 0.2 wide, a twentieth of the square.
fn small_sphere() -> Sphere {
    Sphere::new(EYE + AHEAD * 10.1, 0.1).unwrap()
}

/// In front of all, behind all, and through the eye.
fn planes() -> World<()> {
    let plane = |normal, ahead| Plane::new(EYE + AHEAD * ahead, normal).unwrap();
    World::new(Color::BLACK)
        .unwrap()
        .with(plane(Normal3::new(0.0, 0.0, 1.0), 1.0), ())
        .with(plane(Normal3::new(0.6, 0.8, 0.0), 0.0), ())
        .with(plane(Normal3::new(0.0, 0.0, 1.0), 100.0), ())
}

/// A shape that does not say where it ends.
#[derive(Debug)]
struct Endless;

impl Geometry for Endless {
    fn hit(&self, _: &Ray, _: Interval) -> Option<Hit> {
        None
    }
}

/// Around the sphere, touched by it on each side, and beside it on each side.
const AROUND: [f64; 2] = [0.0, 0.0];
const TOUCHED: [[f64; 2]; 4] = [[2.05, 0.0], [-2.05, 0.0], [0.0, 2.05], [0.0, -2.05]];
const BESIDE: [[f64; 2]; 4] = [[2.15, 0.0], [-2.15, 0.0], [0.0, 2.15], [0.0, -2.15]];

fn may_hide(world: &World<()>, at: [f64; 2], narrow: f64) -> bool {
    let search = world.search().expect("a prepared world");
    search.may_hide(&square(at), narrow)
}

/// Whatever else is told of the world: the sphere is found where it is.
fn check_sphere(world: &World<()>) {
    for at in TOUCHED.into_iter().chain([AROUND]) {
        assert!(may_hide(world, at, 0.0501), "{at:?}");
        assert!(!may_hide(world, at, 0.0499), "{at:?}");
    }
    for at in BESIDE {
        assert!(!may_hide(world, at, 0.0501), "{at:?}");
    }
}

#[test]
fn a_small_sphere_hides_where_it_is() {
    let world = World::new(Color::BLACK).unwrap().with(small_sphere(), ());
    check_sphere(&world.prepared([Focus::Point(EYE)]));
}

#[test]
fn planes_hide_nothing_and_change_nothing() {
    let check_planes = |world: World<()>| {
        for at in BESIDE.into_iter().chain([AROUND]) {
            assert!(!may_hide(&world, at, 1.0), "{at:?}");
        }
    };
    check_planes(planes().prepared([Focus::Point(EYE)]));
    check_planes(planes().prepared([]));
    check_planes(World::new(Color::BLACK).unwrap().prepared([]));
    let with_sphere = planes().with(small_sphere(), ());
    check_sphere(&with_sphere.prepared([Focus::Point(EYE)]));
}

#[test]
fn what_has_no_end_and_is_no_plane_may_hide_anywhere() {
    let empty = || World::new(Color::BLACK).unwrap();
    let worlds = [
        empty().with(Endless, ()),
        planes().with(Endless, ()),
        empty().with(small_sphere(), ()).with(Endless, ()),
    ];
    for world in worlds {
        let world = world.prepared([Focus::Point(EYE)]);
        for at in BESIDE.into_iter().chain([AROUND]) {
            assert!(may_hide(&world, at, 0.01), "{at:?}");
        }
    }
}

/// Not known is yes: of no focus, of others, and of one that sees the sphere on all
/// sides.
#[test]
fn seen_from_where_nothing_is_known_anything_may_hide() {
    let beside = Focus::Point(EYE + Vector3::new(0.0, 0.0, 1e-9));
    let foci: [&[Focus]; 4] = [
        &[],
        &[beside],
        &[Focus::Direction(AHEAD)],
        &[Focus::Direction(AHEAD), beside],
    ];
    for foci in foci {
        let world = planes().with(small_sphere(), ());
        let world = world.prepared(foci.iter().copied());
        for at in BESIDE.into_iter().chain([AROUND]) {
            assert!(may_hide(&world, at, 0.01), "{at:?} from {foci:?}");
        }
    }
    let around_the_eye = Sphere::new(EYE, 5.0).unwrap();
    let world = planes().with(around_the_eye, ());
    assert!(may_hide(&world.prepared([Focus::Point(EYE)]), AROUND, 0.01));
}

#[test]
fn of_several_foci_that_of_the_rays_counts() {
    let lamp = Focus::Point(EYE + Vector3::new(3.0, 4.0, 0.0));
    let sun = Focus::Direction(AHEAD);
    for foci in [
        [lamp, Focus::Point(EYE), sun],
        [sun, lamp, Focus::Point(EYE)],
    ] {
        let world = planes().with(small_sphere(), ());
        check_sphere(&world.prepared(foci));
    }
}
