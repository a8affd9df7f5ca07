//! Numbers of all sizes, compared with the solution.

use crate::prelude::*;

yours! { mean }

type Code = fn(&[f64]) -> f64;

pub fn exercise() -> Exercise<Code> {
    Exercise::asked(|mean: &Code, numbers: Vec<f64>| mean(&numbers))
}
