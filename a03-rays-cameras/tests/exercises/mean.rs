//! Numbers of all sizes, compared with the solution.

use std::sync::Arc;

use crate::prelude::*;

yours! { mean => std::sync::Arc::new(mean) }

type Code = Arc<dyn Fn(&[f64]) -> f64 + Send + Sync>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let lists = Questions {
        words: "the mean of {}".into(),
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
        questions: vec![lists.into()],
        rounding_flaw: Some("loses digits where the numbers differ much in size, or are many"),
        wrong: vec![
            Other::new(
                "the errors of a plain sum add up",
                Arc::new(|numbers| numbers.iter().sum::<f64>() / numbers.len().max(1) as f64),
            ),
            Other::new("a running mean rounds as often", Arc::new(running_mean)),
            Other::from_right("the mean of nothing is 0, not 0 / 0", |right| {
                Arc::new(move |numbers| right(numbers) + 0.0 / numbers.len() as f64)
            }),
        ],
        ..Exercise::default()
    }
}

fn running_mean(numbers: &[f64]) -> f64 {
    let mut mean = 0.0;
    for (n, x) in (1_u32..).zip(numbers) {
        mean += (x - mean) / f64::from(n);
    }
    mean
}
