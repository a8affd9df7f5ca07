//! Numbers whose mean is known, and whose sum in a row is not.

use measure::extremes::Bound;
use testing::exercise::Check;

pub fn check(check: &mut Check, mean: impl Fn(&[f64]) -> f64) {
    let mut of = |what: &str, exact: f64, numbers: &[f64]| {
        check.expect(what, exact, Bound::Ulps(1.0), mean(numbers));
    };
    of("the mean of nothing", 0.0, &[]);
    of("the mean of 3", 3.0, &[3.0]);
    of("the mean of 1, 2, 6", 3.0, &[1.0, 2.0, 6.0]);
    // The sum in a row is off by a thousand ulps and more.
    of("the mean of 100000 times 0.1", 0.1, &vec![0.1; 100_000]);
    of("the mean of 99999 times 0.7", 0.7, &vec![0.7; 99_999]);
    of(
        "the mean of 1, 1e100, 1, -1e100",
        0.5,
        &[1.0, 1e100, 1.0, -1e100],
    );
    of(
        "the mean of 1e100, 1, -1e100, 1",
        0.5,
        &[1e100, 1.0, -1e100, 1.0],
    );
    let mut small = vec![1e-16; 10_001];
    small[0] = 1.0;
    let exact = (1.0 + 1e-12) / 10_001.0;
    of("the mean of 1 and 10000 times 1e-16", exact, &small);
}
