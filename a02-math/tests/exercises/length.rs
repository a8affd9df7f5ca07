//! Vectors of all lengths.

use crate::prelude::*;

yours! { length }

pub fn exercise() -> Exercise<fn(f64, f64, f64) -> f64> {
    Exercise::asked(|length, [x, y, z]: [f64; 3]| length(x, y, z))
}
