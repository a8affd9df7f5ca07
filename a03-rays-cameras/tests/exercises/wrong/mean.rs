//! Sums that drift, and an empty list.

use testing::exercise::Wrong;

use crate::mean::check;

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

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the plain sum, divided",
        says: "the mean of 100000 times 0.1: expected 0.1, got 0.10000000000018848",
        check: |c| {
            check(c, |numbers| {
                numbers.iter().sum::<f64>() / numbers.len().max(1) as f64
            });
        },
    },
    Wrong {
        mistake: "divided by 0 for an empty list",
        says: "the mean of nothing: expected 0, got NaN",
        check: |c| check(c, |numbers| kahan(numbers) / numbers.len() as f64),
    },
    Wrong {
        mistake: "Kahan's sum, blind to a larger number that follows",
        says: "the mean of 1, 1e100, 1, -1e100: expected 0.5, got 0",
        check: |c| check(c, |numbers| kahan(numbers) / numbers.len().max(1) as f64),
    },
    Wrong {
        mistake: "a running mean",
        says: "the mean of 1, 1e100, 1, -1e100: expected 0.5",
        check: |c| {
            check(c, |numbers| {
                (1_u32..)
                    .zip(numbers)
                    .fold(0.0, |mean, (n, x)| mean + (x - mean) / f64::from(n))
            });
        },
    },
    Wrong {
        mistake: "small numbers first",
        says: "the mean of 100000 times 0.1: expected 0.1",
        check: |c| {
            check(c, |numbers| {
                let mut numbers = numbers.to_vec();
                numbers.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
                numbers.iter().sum::<f64>() / numbers.len().max(1) as f64
            });
        },
    },
    Wrong {
        mistake: "divided before they are added",
        says: "the mean of 100000 times 0.1: expected 0.1",
        check: |c| {
            check(c, |numbers| {
                numbers.iter().map(|x| x / numbers.len() as f64).sum()
            });
        },
    },
    Wrong {
        mistake: "the lost part subtracted",
        says: "the mean of 100000 times 0.1: expected 0.1",
        check: |c| {
            check(c, |numbers| {
                let (sum, lost) = numbers
                    .iter()
                    .fold((0.0, 0.0), |(sum, lost): (f64, f64), &x| {
                        let next = sum + x;
                        let (large, small) = if sum.abs() >= x.abs() {
                            (sum, x)
                        } else {
                            (x, sum)
                        };
                        (next, lost + (next - large) - small)
                    });
                (sum + lost) / numbers.len().max(1) as f64
            });
        },
    },
];
