//! The formulas of the protocol.
//!
//! On whole numbers the formulas are right, so that only the extreme
//! cases make them fail.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Plane, World};
use a05_lighting::SingleColor;
use a06_shadows_reflection::protocol::{
    OneCounter, directional_light_illuminates, lambert, point_light_illuminates,
    reflection_inside_sum, spot_light_illuminates,
};
use a06_shadows_reflection::{Reflective, ShadowedWorld};
use common::Color;

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

fn at(y: f64) -> Point3 {
    Point3::new(0.0, y, 0.0)
}

/// A floor at this height.
fn floor(y: f64) -> World<()> {
    let plane = Plane::new(at(y), UP.as_normal()).unwrap();
    World::new(Color::BLACK).unwrap().with(plane, ())
}

/// From 0 to a light at 4: a point light is hidden by `t` below its distance, which is 0.25
/// at 1, and 4 at 16. A spot light is hidden in the same way by objects behind the point.
/// The ray of a directional light has no end.
#[test]
fn lights_are_hidden_as_the_text_says() {
    let point = |y| point_light_illuminates(at(4.0), at(0.0), &floor(y));
    assert_eq!([-1.0, 0.004, 16.0].map(point), [true; 3]);
    assert_eq!([0.005, 1.0, 15.0].map(point), [false; 3]);
    let spot = |y| spot_light_illuminates(at(4.0), at(0.0), &floor(y));
    assert_eq!(
        [1.0, -1.0, -15.0, -16.0].map(spot),
        [true, false, false, true]
    );
    let far = |y| directional_light_illuminates(-UP, at(0.0), &floor(y));
    assert_eq!([1.0, 1e9, -1.0].map(far), [false, false, true]);
}

#[test]
fn the_cosine_is_not_clamped_where_it_is_no_number() {
    let n = UP.as_normal();
    let cosine = |x, y| lambert(n, Point3::new(x, y, 0.0), Point3::ORIGIN);
    assert_eq!((cosine(3.0, 4.0), cosine(3.0, -4.0)), (0.8, 0.0));
    assert!(cosine(0.0, 0.0).is_nan());
}

#[test]
fn the_reflection_counts_once_for_each_light() {
    assert_eq!(reflection_inside_sum(&[], 0.5, 4.0), 0.0);
    assert_eq!(reflection_inside_sum(&[1.0], 0.5, 4.0), 3.0);
    assert_eq!(reflection_inside_sum(&[1.0, 8.0], 0.5, 4.0), 13.0);
}

/// The floor mirrors the ceiling, or at the limit the background instead of
/// black.
#[test]
fn the_counter_counts_rays() {
    let (grey, black) = (Color::gray(0.5), Color::BLACK);
    let mirror = Reflective::new(black, black, 1.0, grey).unwrap();
    let [floor, ceiling] = [0.0, 2.0].map(|y| Plane::new(at(y), UP.as_normal()).unwrap());
    let world = ShadowedWorld::empty(Color::WHITE, black)
        .unwrap()
        .with(floor, Box::new(mirror))
        .with(ceiling, Box::new(SingleColor::new(Color::RED).unwrap()));
    let world = &world;
    let trace = |recursion| OneCounter { world, recursion }.trace(&Ray::derived(at(1.0), -UP));
    assert_eq!(trace(0), Color::WHITE);
    assert_eq!(trace(1), grey);
    assert_eq!(trace(2), Color::RED * 0.5);
}
