//! `DoubleDouble`: a number as the unevaluated sum of two doubles.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A sum of two doubles with about 31 digits. The second is at most half a unit in
/// the last place of the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

/// The rounded sum and its rounding error (Knuth, The Art of Computer
/// Programming, volume 2, section 4.2.2).
pub fn sum_with_error(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_of_sum = sum - a;
    (sum, (a - (sum - b_of_sum)) + (b - b_of_sum))
}

/// The rounded product and its rounding error.
#[allow(
    clippy::disallowed_methods,
    reason = "one rounding instead of two is what makes the error exact"
)]
pub fn product_with_error(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    (product, a.mul_add(b, -product))
}

impl DoubleDouble {
    /// The sum of a double and a much smaller one.
    fn normalized(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self {
            high: sum,
            low: low - (sum - high),
        }
    }

    /// The nearest double.
    pub const fn value(self) -> f64 {
        self.high
    }

    /// The difference of a double and this number.
    pub fn error_of(self, computed: f64) -> f64 {
        (computed - self.high) - self.low
    }

    /// The square root of a number that is not negative.
    pub fn sqrt(self) -> Self {
        let root = self.high.sqrt();
        if root == 0.0 {
            return Self::from(0.0);
        }
        let rest = self - Self::from(root) * Self::from(root);
        Self::normalized(root, rest.high / (2.0 * root))
    }
}

impl From<f64> for DoubleDouble {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, error) = sum_with_error(self.high, other.high);
        let (low, lowest) = sum_with_error(self.low, other.low);
        let sum = Self::normalized(high, error + low);
        Self::normalized(sum.high, sum.low + lowest)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (high, error) = product_with_error(self.high, other.high);
        let low = error + (self.high * other.low + self.low * other.high);
        Self::normalized(high, low)
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * Self::from(first);
        let second = rest.high / other.high;
        let rest = rest - other * Self::from(second);
        let quotient = Self::normalized(first, second);
        Self::normalized(quotient.high, quotient.low + rest.high / other.high)
    }
}
