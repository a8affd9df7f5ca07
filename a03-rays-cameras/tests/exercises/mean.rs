//! Numbers of all sizes, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: fn(&[f64]) -> f64) {
    check.exactly("loses digits where the numbers differ much in size, or are many");
    let small = [vec![], vec![3.0], vec![1.0, 2.0, 6.0]];
    let large = [vec![1.0, 1e100, 1.0, -1e100], vec![1e100, 1.0, -1e100, 1.0]];
    check.compare(
        "the mean of {}",
        small.into_iter().chain(large).chain([vec![0.1; 1000]]),
        random(|r| {
            (0..=r.below(20))
                .map(|_| r.between(-9.0, 9.0) * r.scale())
                .collect()
        }),
        [mean, yours],
        |mean, numbers: Vec<f64>| mean(&numbers),
    );
}

variants! { check:
    yours => mean;
    wrong "the errors of a plain sum add up" => |numbers| {
        numbers.iter().sum::<f64>() / numbers.len().max(1) as f64
    };
    wrong "a running mean rounds as often" => |numbers| {
        let numbered = (1_u32..).zip(numbers);
        numbered.fold(0.0, |mean, (n, x)| mean + (x - mean) / f64::from(n))
    };
    wrong "the mean of nothing is 0, not 0 / 0" => |numbers| {
        mean(numbers) + 0.0 / numbers.len() as f64
    };
}
