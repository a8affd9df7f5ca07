//! Planes whose normal is known before and after, and ways in them.

use a02_math::{Direction, Normal3, Vector3};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

/// Some roundings of coordinates up to 1.
const BOUND: Bound = Bound::Absolute(1e-15);

pub fn check(check: &mut Check, stretched: impl Fn(Normal3, [f64; 3]) -> Option<Normal3>) {
    let mut to = |n: [f64; 3], factors: [f64; 3], exact: Option<[f64; 3]>| {
        let got = stretched(Normal3::from_glam(n.into()), factors);
        let got = got.map(|n| n.to_glam().to_array());
        let what = format!("the normal {n:?}, stretched by {factors:?}");
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
    to([0.6, 0.0, 0.8], [1.0, 1.0, -1.0], Some([0.6, 0.0, -0.8]));
    to([0.6, 0.8, 0.0], [-5.0; 3], Some([-0.6, -0.8, 0.0]));
    for factors in [[0.0, 1.0, 1.0], [1.0, 0.0, 1.0], [1.0, 1.0, 0.0]] {
        to([0.6, 0.8, 0.0], factors, None);
        to([2.0 * third, third, 2.0 * third], factors, None);
    }
    to([0.0; 3], [1.0, 2.0, 3.0], None);

    let mut random = Random::new(5);
    let mut ways = |n: [f64; 3], factors: [f64; 3]| {
        let got = stretched(Normal3::from_glam(n.into()), factors);
        let [x, y, z] = n;
        // Perpendicular to the normal, by whole numbers.
        for way in [[-y, x, 0.0], [0.0, -z, y], [z, 0.0, -x]] {
            let [x, y, z] = [0, 1, 2].map(|i| way[i] * factors[i]);
            let way_there = Vector3::new(x, y, z);
            let length = way_there.magnitude();
            if length > 0.0 {
                let cos = got.map(|n| n.dot(way_there) / length);
                let what = format!(
                    "cosine between {way:?} and its normal {n:?}, both stretched by {factors:?}"
                );
                check.expect(what, Some(0.0), BOUND, cos);
            }
        }
        let length = got.map(|n| Vector3::from(n).magnitude());
        let what = format!("length of the normal {n:?}, stretched by {factors:?}");
        check.expect(what, Some(1.0), BOUND, length);
        // A way that leads out still does.
        let out = got.map(|got| {
            let [x, y, z] = [0, 1, 2].map(|i| n[i] * factors[i]);
            got.dot(Vector3::new(x, y, z)) > 0.0
        });
        let what = format!("the normal {n:?} still points out, stretched by {factors:?}");
        check.expect(what, Some(true), Bound::Equal, out);
    };
    for factors in [[2.0, 1.0, 1.0], [0.5, 3.0, -7.0], [100.0, 1.0, 0.01]] {
        ways([2.0, -3.0, 6.0], factors);
    }
    for _ in 0..30 {
        let n = [(); 3].map(|()| f64::from(random.below(17)) - 8.0);
        let factors = [(); 3].map(|()| {
            let factor = random.between(0.1, 9.0);
            if random.below(3) == 0 {
                -factor
            } else {
                factor
            }
        });
        if n != [0.0; 3] {
            ways(n, factors);
        }
    }
}
