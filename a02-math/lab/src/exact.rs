//! Arithmetic with twice the digits of a double: `DoubleDouble`, a number as the unevaluated
//! sum of two doubles.

use std::ops::{Add, Div, Mul, Sub};

/// The rounded sum and its rounding error (Knuth, The Art of Computer
/// Programming, volume 2, section 4.2.2).
pub fn sum_with_error(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_of_sum = sum - a;
    (sum, (a - (sum - b_of_sum)) + (b - b_of_sum))
}

/// The sum of products, rounded as if computed with twice the digits.
pub fn sum_of_products(pairs: &[(f64, f64)]) -> f64 {
    let product = |(a, b): &(f64, f64)| DoubleDouble::from(*a) * (*b).into();
    let products = pairs.iter().map(product);
    products.fold(DoubleDouble::from(0.0), Add::add).value()
}

/// A sum of two doubles with about 31 digits. The second is at most half a unit in
/// the last place of the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleDouble(f64, f64);

impl DoubleDouble {
    /// The sum of a double and a much smaller one.
    fn normalized(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self(sum, low - (sum - high))
    }

    /// The nearest double.
    pub const fn value(self) -> f64 {
        self.0
    }

    /// The difference of a double and this number.
    pub fn error_of(self, computed: f64) -> f64 {
        (computed - self.0) - self.1
    }

    /// The power, by repeated squaring. The rounding errors add up to P units of the 31st digit:
    /// 19 digits are left for a P of 1e12.
    #[must_use]
    pub fn power(self, exponent: u64) -> Self {
        match exponent {
            0 => 1.0.into(),
            odd if odd % 2 == 1 => self * self.power(odd - 1),
            even => (self * self).power(even / 2),
        }
    }

    /// The square root of a number that is not negative.
    #[must_use]
    pub fn sqrt(self) -> Self {
        let root = self.0.sqrt();
        if root == 0.0 {
            return Self::from(0.0);
        }
        let rest = self - Self::from(root) * Self::from(root);
        Self::normalized(root, rest.0 / (2.0 * root))
    }
}

impl From<f64> for DoubleDouble {
    fn from(number: f64) -> Self {
        Self(number, 0.0)
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, error) = sum_with_error(self.0, other.0);
        let (low, lowest) = sum_with_error(self.1, other.1);
        let sum = Self::normalized(high, error + low);
        Self::normalized(sum.0, sum.1 + lowest)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + Self(-other.0, -other.1)
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    /// The fused operation gives the rounding error of the product of the high parts (Ogita,
    /// Rump, Oishi: Accurate Sum and Dot Product, 2005).
    #[allow(
        clippy::disallowed_methods,
        reason = "one rounding instead of two is what makes the error exact"
    )]
    fn mul(self, other: Self) -> Self {
        let high = self.0 * other.0;
        let error = self.0.mul_add(other.0, -high);
        Self::normalized(high, error + (self.0 * other.1 + self.1 * other.0))
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let first = self.0 / other.0;
        let rest = self - other * Self::from(first);
        let second = rest.0 / other.0;
        let rest = rest - other * Self::from(second);
        let quotient = Self::normalized(first, second);
        Self::normalized(quotient.0, quotient.1 + rest.0 / other.0)
    }
}
