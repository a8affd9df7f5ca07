//! Planes whose normal is known before and after, and ways in them.

use a02_math::{Direction, Normal3, Vector3};
use measure::extremes::Bound;
use testing::exercise::Check;

/// Some roundings of coordinates up to 1.
const BOUND: Bound = Bound::Absolute(1e-15);

pub fn check(check: &mut Check, stretched: impl Fn(Normal3, [f64; 3]) -> Option<Normal3>) {
    let mut to = |n: [f64; 3], factors: [f64; 3], exact: Option<[f64; 3]>| {
        let got = stretched(Normal3::from_glam(n.into()), factors);
        let got = got.map(|n| n.to_glam().to_array());
        let what = format!("{n:?}, stretched by {factors:?}");
        check.expect(what, exact, BOUND, got);
    };
    let third = 1.0 / 3.0;
    to([0.0, 1.0, 0.0], [2.0, 3.0, 4.0], Some([0.0, 1.0, 0.0]));
    to([0.6, 0.8, 0.0], [1.0; 3], Some([0.6, 0.8, 0.0]));
    to([0.6, 0.8, 0.0], [5.0; 3], Some([0.6, 0.8, 0.0]));
    // Fractions before, fractions after.
    to(
        [0.6, 0.8, 0.0],
        [0.75, 4.0 / 3.0, 9.0],
        Some([0.8, 0.6, 0.0]),
    );
    to([0.8, 0.0, 0.6], [2.0, 1.0, 2.0], Some([0.8, 0.0, 0.6]));
    to(
        [1.0, 1.0, 1.0],
        [1.0, 0.5, 0.5],
        Some([third, 2.0 * third, 2.0 * third]),
    );
    to(
        [2.0, 1.0, 2.0],
        [2.0, 0.5, 1.0],
        Some([third, 2.0 * third, 2.0 * third]),
    );
    // A mirror turns the normal over with the surface.
    to([0.6, 0.8, 0.0], [-1.0, 1.0, 1.0], Some([-0.6, 0.8, 0.0]));
    for factors in [[0.0, 1.0, 1.0], [1.0, 0.0, 1.0], [1.0, 1.0, 0.0]] {
        to([0.6, 0.8, 0.0], factors, None);
    }
    to([0.0; 3], [1.0, 2.0, 3.0], None);

    for factors in [[2.0, 1.0, 1.0], [0.5, 3.0, -7.0], [100.0, 1.0, 0.01]] {
        let n = Normal3::new(2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0);
        let got = stretched(n, factors);
        // Perpendicular to the normal: 6 - 6 + 0 and so on.
        for way in [[3.0, 2.0, 0.0], [0.0, 2.0, 1.0], [-3.0, 0.0, 1.0]] {
            let [x, y, z] = [0, 1, 2].map(|i| way[i] * factors[i]);
            let length = Vector3::new(x, y, z).magnitude();
            let cos = got.map(|n| n.dot(Vector3::new(x, y, z)) / length);
            let what = format!("the cosine between normal and {way:?}, stretched by {factors:?}");
            check.expect(what, Some(0.0), BOUND, cos);
        }
        let length = got.map(|n| Vector3::from(n).magnitude());
        let what = format!("the length of the normal, stretched by {factors:?}");
        check.expect(what, Some(1.0), BOUND, length);
    }
}
