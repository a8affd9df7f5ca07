//! Turns whose sine and cosine are fractions, and the one by a third of a
//! circle that shifts x to y, y to z and z to x.

use std::f64::consts::{FRAC_PI_2, PI};

use a02_math::Vector3;
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

/// Some roundings of coordinates up to 20.
const BOUND: Bound = Bound::Absolute(3e-14);

pub fn check(check: &mut Check, rotated: impl Fn(Vector3, Vector3, f64) -> Vector3) {
    let mut turn = |v: [f64; 3], axis: [f64; 3], angle: f64, exact: [f64; 3]| {
        let vector = |xyz: [f64; 3]| Vector3::from_glam(xyz.into());
        let got = rotated(vector(v), vector(axis), angle).to_glam().to_array();
        let what = format!("the vector {v:?}, turned around {axis:?} by {angle}");
        check.expect(what, exact, BOUND, got);
    };
    let v = [1.0, 2.0, 3.0];
    for length in [1.0, 0.25, 7.0] {
        turn(v, [length, 0.0, 0.0], FRAC_PI_2, [1.0, -3.0, 2.0]);
        turn(v, [0.0, length, 0.0], FRAC_PI_2, [3.0, 2.0, -1.0]);
        turn(v, [0.0, 0.0, length], FRAC_PI_2, [-2.0, 1.0, 3.0]);
        turn(v, [0.0, 0.0, -length], FRAC_PI_2, [2.0, -1.0, 3.0]);
        turn(v, [length; 3], 2.0 * PI / 3.0, [3.0, 1.0, 2.0]);
        turn(v, [length; 3], -2.0 * PI / 3.0, [2.0, 3.0, 1.0]);
        // Half a turn is a reflection on the axis: 2 (k · v) k - v.
        let axis = [2.0, -1.0, 2.0].map(|x: f64| x * length);
        turn(v, axis, PI, [5.0 / 3.0, -10.0 / 3.0, -1.0 / 3.0]);
        turn(axis, axis, 1.0, axis);
        for (sin, cos) in [(0.6, 0.8), (-0.28, 0.96), (12.0 / 13.0, -5.0 / 13.0)] {
            let exact = [cos - 2.0 * sin, sin + 2.0 * cos, 3.0];
            turn(v, [0.0, 0.0, length], libm::atan2(sin, cos), exact);
        }
    }
    // The turn by 2 atan2(m, w), m being the axis's length, as the quaternion
    // (w, axis) makes it: Hamilton's w² v + 2 w a × v + 2 (a · v) a - |a|² v over w² + |a|².
    let mut random = Random::new(4);
    let mut whole = || f64::from(random.below(13)) - 6.0;
    for _ in 0..40 {
        let (v, [a, b, c]) = ([whole(), whole(), whole()], [whole(), whole(), whole()]);
        let (w, squared) = (whole(), a * a + b * b + c * c);
        if squared == 0.0 {
            continue;
        }
        let [x, y, z] = v;
        let (along, keep) = (2.0 * (a * x + b * y + c * z), w * w - squared);
        let across = [b * z - c * y, c * x - a * z, a * y - b * x];
        let exact: [f64; 3] = std::array::from_fn(|i| {
            (keep * v[i] + 2.0 * w * across[i] + along * [a, b, c][i]) / (w * w + squared)
        });
        turn(v, [a, b, c], 2.0 * libm::atan2(squared.sqrt(), w), exact);
    }
    turn(v, [3.0, 4.0, 5.0], 0.0, v);
    turn(v, [0.0; 3], 1.0, v);
    turn([0.0; 3], [0.0, 1.0, 0.0], 1.0, [0.0; 3]);
}
