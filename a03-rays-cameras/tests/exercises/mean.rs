//! Numbers of all sizes, compared with the solution.

use crate::prelude::*;
use crate::solutions::mean::mean as solution;

pub fn check(check: &mut Check, mean: impl Fn(&[f64]) -> f64) {
    check.exactly("loses digits where the numbers differ much in size, or are many");
    let small = [vec![], vec![3.0], vec![1.0, 2.0, 6.0]];
    let large = [vec![1.0, 1e100, 1.0, -1e100], vec![1e100, 1.0, -1e100, 1.0]];
    check.compare(
        "the mean of {}",
        small.into_iter().chain(large).chain([vec![0.1; 1000]]),
        random(|r| {
            (0..1 + r.below(20))
                .map(|_| r.between(-9.0, 9.0) * r.scale())
                .collect()
        }),
        |numbers: Vec<f64>| solution(&numbers),
        |numbers| mean(&numbers),
    );
}

/// The sum by Kahan (1965), which loses the digits that a larger number pushes out.
fn kahan(numbers: &[f64]) -> f64 {
    let (mut sum, mut lost) = (0.0, 0.0);
    for x in numbers {
        let x = x - lost;
        let next: f64 = sum + x;
        lost = (next - sum) - x;
        sum = next;
    }
    sum
}

pub const VARIANTS: &[Variant] = &[
    wrong("the errors of a plain sum add up", |c| {
        check(c, |numbers| {
            numbers.iter().sum::<f64>() / numbers.len().max(1) as f64
        });
    }),
    wrong(
        "a sum does not see what a larger number behind it pushes out",
        |c| {
            check(c, |numbers| kahan(numbers) / numbers.len().max(1) as f64);
        },
    ),
    wrong("the mean of nothing is 0, not 0 / 0", |c| {
        check(c, |numbers| {
            if numbers.is_empty() {
                f64::NAN
            } else {
                solution(numbers)
            }
        });
    }),
];
