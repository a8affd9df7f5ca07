//! Numbers of all sizes, compared with the solution.

use crate::prelude::*;
use crate::solutions::mean::mean as right;

yours! { mean }

type Code = fn(&[f64]) -> f64;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let lists = Questions {
        words: "the mean of {}",
        simple: vec![
            vec![],
            vec![3.0],
            vec![-1.0, 1.0],
            vec![1.0, 2.0, 6.0],
            vec![1.0, 1e100, 1.0, -1e100],
            vec![1e100, 1.0, -1e100, 1.0],
            vec![0.1; 1000],
        ],
        others: random(|r| {
            let mut numbers = Vec::new();
            for _ in 0..=r.below(20) {
                numbers.push(r.between(-9.0, 9.0) * r.scale());
            }
            numbers
        }),
        answer: |mean: &Code, numbers: Vec<f64>| mean(&numbers),
    };
    Exercise {
        questions: lists.into(),
        wrong: vec![
            Other::new("the errors of a plain sum add up", |numbers| {
                numbers.iter().sum::<f64>() / numbers.len().max(1) as f64
            }),
            Other::new("the mean of nothing is 0, not 0 / 0", |numbers| {
                right(numbers) + 0.0 / numbers.len() as f64
            }),
        ],
        ..Exercise::default()
    }
}
