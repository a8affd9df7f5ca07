//! `DoubleDouble`: a number as the unevaluated sum of two doubles.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A sum of two doubles of which the second is at most half a unit in the last
/// place of the first: about 31 digits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

/// The rounded sum and what rounding took away (Knuth, The Art of Computer
/// Programming, volume 2, section 4.2.2).
pub fn sum_with_error(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_of_sum = sum - a;
    (sum, (a - (sum - b_of_sum)) + (b - b_of_sum))
}

/// The rounded product and what rounding took away.
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

    /// By how much a double is greater than this number.
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

#[cfg(test)]
mod tests {
    use super::*;

    fn power_of_two(exponent: i32) -> f64 {
        libm::scalbn(1.0, exponent)
    }

    fn sum(high: f64, low: f64) -> DoubleDouble {
        DoubleDouble::from(high) + DoubleDouble::from(low)
    }

    /// 1 + 2^-54 and -1 + 2^-107: what is left lies 107 binary digits below.
    #[test]
    fn sums_that_cancel_keep_their_last_digit() {
        let (small, smallest) = (power_of_two(-54), power_of_two(-107));
        let rest = sum(1.0, small) + sum(-1.0, smallest);
        assert_eq!(rest, sum(small, smallest));
        assert_eq!(rest.error_of(small), -smallest);
        let rest = sum(1.0, small) - sum(1.0, smallest);
        assert_eq!(rest.error_of(small), smallest);
    }

    /// The products have few digits and are exact.
    #[test]
    fn what_was_multiplied_by_can_be_divided_out() {
        for digit in [54, 60, 70, 90] {
            let number = sum(1.0, power_of_two(-digit));
            for factor in [3.0, 5.0, 7.0, 0.1875, 10.0, -1e3] {
                let factor = DoubleDouble::from(factor);
                assert_eq!(number * factor / factor, number);
            }
        }
    }

    /// 0.01 0101.. in binary, without end: of 1/3 no more than 106 digits fit.
    #[test]
    fn quotients_are_right_to_the_last_of_106_digits() {
        for divisor in [3.0, 7.0, 11.0, 49.0, 1e6 + 3.0] {
            let divisor = DoubleDouble::from(divisor);
            let quotient = DoubleDouble::from(1.0) / divisor;
            let rest = DoubleDouble::from(1.0) - quotient * divisor;
            assert!(rest.value().abs() <= power_of_two(-104), "{rest:?}");
        }
    }
}
