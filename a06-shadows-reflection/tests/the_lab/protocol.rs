//! The formulas of the protocol.
//!
//! On whole numbers the formulas are right, so that only the extreme
//! cases make them fail. Its tracer is measured by the cases M01 to M19.

use a02_math::{Point3, Vector3};
use a04_intersections::{Plane, World};
use a06_shadows_reflection::protocol::{
    directional_light_illuminates, lambert, point_light_illuminates, reflection_inside_sum,
    spot_light_illuminates,
};
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
