//! Products of vectors of hundredths, whose exact values follow from whole numbers.

use a02_math::Vector3;
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::drawn::{Functions, LESSON, expect_scene};

/// Some roundings of products up to 300.
const BOUND: Bound = Bound::Absolute(1e-12);

pub fn check(
    check: &mut Check,
    dot: fn(Vector3, Vector3) -> f64,
    cross: fn(Vector3, Vector3) -> Vector3,
) {
    let mut case = |a: [i32; 3], b: [i32; 3]| {
        let [x, y, z] = [1, 2, 0].map(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            f64::from(a[j] * b[k] - a[k] * b[j]) / 1e4
        });
        let exact = f64::from((0..3).map(|i| a[i] * b[i]).sum::<i32>()) / 1e4;
        let [a, b] = [a, b].map(|v| v.map(|hundredths| f64::from(hundredths) / 100.0));
        let words = format!("a = {a:?}, b = {b:?}");
        let [a, b] = [a, b].map(|v| Vector3::from_glam(v.into()));
        check.expect(format!("a · b; {words}"), exact, BOUND, dot(a, b));
        // x belongs to the axis after z.
        let got = cross(a, b).to_glam().to_array();
        check.expect(format!("a × b; {words}"), [z, x, y], BOUND, got);
    };
    case([100, 200, 300], [400, 500, 600]);
    case([100, 0, 0], [0, 100, 0]);
    case([0, 100, 0], [100, 0, 0]);
    let mut random = Random::new(21);
    let mut vector = || random.triple(9.0).map(|x| (x * 100.0).round() as i32);
    for _ in 0..20 {
        let a = vector();
        case(a, vector());
        case(a, a.map(|x| -2 * x));
    }
    expect_scene(
        check,
        Functions {
            dot,
            cross,
            ..LESSON
        },
    );
}
