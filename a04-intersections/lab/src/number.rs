//! `Number`: one formula over several types of numbers.
//!
//! In `f64` the rounding errors of a formula are measured; in [`DoubleDouble`], with about 31 digits,
//! it gives the exact value that they are measured against.

use std::ops::{Add, Div, Mul, Neg, Sub};

use measure::exact::DoubleDouble;

/// Three coordinates.
pub type Triple<N = f64> = [N; 3];

/// A type of numbers that formulas are written for.
pub trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The number nearest to a double.
    fn of(number: f64) -> Self;

    /// The root of a number that is not negative.
    #[must_use]
    fn sqrt(self) -> Self;
}

impl Number for f64 {
    fn of(number: f64) -> Self {
        number
    }

    fn sqrt(self) -> Self {
        self.sqrt()
    }
}

impl Number for DoubleDouble {
    fn of(number: f64) -> Self {
        number.into()
    }

    fn sqrt(self) -> Self {
        self.sqrt()
    }
}

pub fn difference<N: Number>(a: &Triple<N>, b: &Triple<N>) -> Triple<N> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn dot<N: Number>(a: &Triple<N>, b: &Triple<N>) -> N {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross<N: Number>(a: &Triple<N>, b: &Triple<N>) -> Triple<N> {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}
