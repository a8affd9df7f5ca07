//! Vectors whose length is a whole number, times every power of ten.

use measure::extremes::Bound;
use testing::exercise::{Check, Random};

pub fn check(check: &mut Check, length: impl Fn(f64, f64, f64) -> f64) {
    let mut of = |[x, y, z]: [f64; 3], exact: f64| {
        let what = format!("the length of ({x:e}, {y:e}, {z:e})");
        check.expect(what, exact, Bound::Ulps(8.0), length(x, y, z));
    };
    of([3.0, 4.0, 0.0], 5.0);
    of([0.0; 3], 0.0);
    of([-0.0, 0.0, -0.0], 0.0);
    // Each of these three in each place, and with each sign.
    for [x, y, z] in [
        [2.0, 3.0, 6.0],
        [-6.0, 2.0, 3.0],
        [3.0, -6.0, -2.0],
        [3.0, 2.0, -6.0],
    ] {
        of([x, y, z], 7.0);
    }
    let mut random = Random::new(2);
    for scale in [
        1.0, 1e-7, 1e100, 1e-100, 1e155, 1e-160, 1e200, 1e-200, 1e306, 1e-299,
    ] {
        for ([x, y, z], whole) in [
            ([3.0, 4.0, 0.0], 5.0),
            ([2.0, -3.0, 6.0], 7.0),
            ([-1.0, 4.0, -8.0], 9.0),
            ([0.0, 0.0, -2.0], 2.0),
        ] {
            of([x * scale, y * scale, z * scale], whole * scale);
        }
        for _ in 0..10 {
            // Lebesgue's identity: (m² + n² - p²)² + (2 m p)² + (2 n p)² = (m² + n² + p²)².
            let [m, n, p] = [(); 3].map(|()| f64::from(random.below(9)) - 4.0);
            let [x, y, z] = [m * m + n * n - p * p, 2.0 * m * p, 2.0 * n * p];
            let whole = m * m + n * n + p * p;
            of([z * scale, x * scale, y * scale], whole * scale);
        }
    }
    // The small ones count for nothing, and do no harm.
    for [x, y, z] in [
        [-1e300, 1e-300, 1e-300],
        [1e-300, -1e300, 1e-300],
        [0.0, 1e-300, 1e300],
    ] {
        of([x, y, z], 1e300);
    }
    of([f64::MAX, 0.0, 0.0], f64::MAX);
    of([0.0, 0.0, -f64::MAX], f64::MAX);
}
