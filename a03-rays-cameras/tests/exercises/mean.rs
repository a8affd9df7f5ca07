//! Numbers of all sizes, compared with the solution.

use crate::prelude::*;

yours! { mean }

type Code = fn(&[f64]) -> f64;

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
        ..Exercise::default()
    }
}
