//! `Real`: the operations of numbers in formulas, for single and for double
//! precision.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// `f32` or `f64`.
pub trait Real:
    Copy
    + PartialOrd
    + From<f32>
    + Into<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The distance between 1 and the next greater number.
    const EPSILON: f64;

    /// The square root; NaN of a negative number.
    fn sqrt(self) -> Self;

    /// This magnitude with the sign of another number.
    fn copysign(self, sign: Self) -> Self;

    /// The number nearest to a double.
    fn rounded(number: f64) -> Self;
}

macro_rules! real {
    ($($float:ident)+) => {$(
        impl Real for $float {
            const EPSILON: f64 = Self::EPSILON as f64;

            fn sqrt(self) -> Self {
                self.sqrt()
            }

            fn copysign(self, sign: Self) -> Self {
                self.copysign(sign)
            }

            fn rounded(number: f64) -> Self {
                number as Self
            }
        }
    )+};
}

real! { f32 f64 }

pub fn difference<F: Real>(a: &[F; 3], b: &[F; 3]) -> [F; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn dot<F: Copy + Add<Output = F> + Mul<Output = F>>(a: &[F; 3], b: &[F; 3]) -> F {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
