//! `Real`: what a formula needs of a number, so that it can be tried in single
//! and in double precision.

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

impl Real for f32 {
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

impl Real for f64 {
    const EPSILON: f64 = Self::EPSILON;

    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn copysign(self, sign: Self) -> Self {
        self.copysign(sign)
    }

    fn rounded(number: f64) -> Self {
        number
    }
}

/// The difference of two triples.
pub fn difference<F: Real>(a: &[F; 3], b: &[F; 3]) -> [F; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The dot product of two triples.
pub fn dot<F: Real>(a: &[F; 3], b: &[F; 3]) -> F {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check<F: Real + std::fmt::Debug>(third: F) {
        let [two, four] = [2.0, 4.0].map(F::from);
        assert_eq!(four.sqrt(), two);
        assert_eq!(two.copysign(-four), -two);
        assert_eq!((-two).copysign(four), two);
        assert_eq!(F::rounded(1.0 / 3.0), third);
        let [a, b] = [[1.0, 2.0, 4.0], [3.0, 5.0, 4.0]].map(|triple| triple.map(F::from));
        assert_eq!(difference(&b, &a), [2.0, 3.0, 0.0].map(F::from));
        assert_eq!(dot(&a, &b), F::from(29.0));
        let next = F::from(1.0) + F::rounded(F::EPSILON);
        assert!(next > F::from(1.0));
        assert_eq!(F::from(1.0) + F::rounded(F::EPSILON / 4.0), F::from(1.0));
    }

    #[test]
    fn singles_and_doubles_do_what_is_asked_of_them() {
        check::<f32>(1.0 / 3.0);
        check::<f64>(1.0 / 3.0);
    }
}
