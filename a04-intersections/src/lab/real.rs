//! `Real`: numbers in formulas of either precision.

use std::ops::{Add, Mul};

use num_traits::{Float, NumCast};

/// `f32` or `f64`.
pub trait Real: Float + Into<f64> {
    /// The number nearest to a double.
    fn rounded(number: f64) -> Self {
        <Self as NumCast>::from(number).unwrap_or_else(Self::nan)
    }
}

impl<F: Float + Into<f64>> Real for F {}

pub fn difference<F: Real>(a: &[F; 3], b: &[F; 3]) -> [F; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn dot<F: Copy + Add<Output = F> + Mul<Output = F>>(a: &[F; 3], b: &[F; 3]) -> F {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
