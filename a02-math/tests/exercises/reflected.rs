//! Vectors with known parts along a normal and along the surface.

use a02_math::{Normal3, Vector3};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::drawn::{Functions, LESSON, expect_scene};

pub fn check(check: &mut Check, reflected: fn(Vector3, Normal3) -> Vector3) {
    let mut random = Random::new(23);
    let mut case = |kind: &str, [n, side]: [Vector3; 2], height: f64, aside: f64| {
        let (v, exact) = (n * height + side * aside, n * height - side * aside);
        let what = format!("{kind}; v = {:.3}, n = {:.3}", v.to_glam(), n.to_glam());
        let [exact, got] = [exact, reflected(v, n.as_normal())].map(|v| v.to_glam().to_array());
        check.expect(what, exact, Bound::Absolute(1e-13), got);
    };
    let axes = [Vector3::new(0.0, 1.0, 0.0), Vector3::new(1.0, 0.0, 0.0)];
    case("on the floor", axes, 1.0, -2.0);
    for _ in 0..20 {
        let [n, side, _] = random.frame().map(|v| Vector3::from_glam(v.into()));
        case("along the normal", [n, side], random.between(0.1, 5.0), 0.0);
        case(
            "along the surface",
            [n, side],
            0.0,
            random.between(0.1, 5.0),
        );
        case(
            "at an angle",
            [n, side],
            random.between(0.1, 5.0),
            random.between(-5.0, 5.0),
        );
        case(
            "from behind",
            [n, side],
            random.between(-5.0, -0.1),
            random.between(-5.0, 5.0),
        );
    }
    expect_scene(
        check,
        Functions {
            reflected,
            ..LESSON
        },
    );
}
