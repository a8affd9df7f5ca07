//! Vectors of all lengths at known angles: tiny, acute, right, obtuse, straight.

use std::f64::consts::{FRAC_PI_2, PI};

use a02_math::Vector3;
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::drawn::{Functions, LESSON, expect_scene};

pub fn check(check: &mut Check, angle: fn(Vector3, Vector3) -> f64) {
    let mut random = Random::new(22);
    let mut expect = |kind: &str, a: Vector3, b: Vector3, exact: f64, bound: f64| {
        let what = format!("{kind}; a = {:.3}, b = {:.3}", a.to_glam(), b.to_glam());
        check.expect(what, exact, Bound::Absolute(bound), angle(a, b));
    };
    let (x, y) = (Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 1.0, 0.0));
    expect("a right angle", x, y, FRAC_PI_2, 1e-15);
    expect("the same direction", x, x * 3.0, 0.0, 0.0);
    expect("opposite directions", x, -x, PI, 1e-15);
    expect("a zero vector", x, Vector3::default(), 0.0, 0.0);
    for _ in 0..20 {
        let [n, side, _] = random.frame().map(|v| Vector3::from_glam(v.into()));
        let lengths = [(); 2].map(|()| random.between(0.1, 9.0));
        let mut at = |kind: &str, exact: f64, bound: f64| {
            let (sin, cos) = libm::sincos(exact);
            let b = n * cos + side * sin;
            expect(kind, n * lengths[0], b * lengths[1], exact, bound);
        };
        at("an acute angle", random.between(0.2, 1.5), 1e-14);
        at("an obtuse angle", random.between(1.6, 3.1), 1e-14);
    }
    for exact in [1e-3, 1e-6, 1e-9, 1e-12] {
        let (sin, cos) = libm::sincos(exact);
        let b = Vector3::new(cos, sin, 0.0) * 2.0;
        expect(
            &format!("a tiny angle, {exact:e}"),
            x,
            b,
            exact,
            exact * 1e-9,
        );
    }
    expect_scene(check, Functions { angle, ..LESSON });
}
