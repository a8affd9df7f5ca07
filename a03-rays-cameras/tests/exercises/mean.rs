//! Numbers whose mean is known, and whose sum in a row is not.

use measure::extremes::Bound;
use testing::exercise::{Check, Random};

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

    // Whole numbers times powers of two, whose sum fits 128 bits.
    let mut random = Random::new(2);
    for n in 1..=60 {
        let numbers: Vec<i128> = std::iter::repeat_with(|| {
            let size = i128::from(1 + random.below(1000));
            size << random.below(70)
        })
        .take(n)
        // Signs by turns keep the sum small, so that each number counts.
        .scan(0, |sum: &mut i128, x| {
            let x = if *sum > 0 { -x } else { x };
            *sum += x;
            Some(x)
        })
        .collect();
        let exact = numbers.iter().sum::<i128>() as f64 / n as f64;
        let as_floats: Vec<_> = numbers.iter().map(|&x| x as f64).collect();
        let what = format!("the mean of {n} whole numbers from {} on", numbers[0]);
        of(&what, exact, &as_floats);
    }
}
