//! Arithmetic with twice the digits of a double: `DoubleDouble`, a number as the unevaluated
//! sum of two doubles.
//!
//! Each operation is inlined, because the formulas of the laboratories are optimised, and this crate is not.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A rounded sum, and what rounding has lost: together they are the exact sum.
struct RoundedSum {
    sum: f64,
    error: f64,
}

/// The rounded sum and its rounding error (Knuth, The Art of Computer
/// Programming, volume 2, section 4.2.2).
#[inline]
fn sum_with_error(a: f64, b: f64) -> RoundedSum {
    let sum = a + b;
    let b_of_sum = sum - a;
    let a_of_sum = sum - b_of_sum;
    RoundedSum {
        sum,
        error: (a - a_of_sum) + (b - b_of_sum),
    }
}

/// The sum of products of pairs, rounded as if computed with twice the digits.
pub fn sum_of_products(pairs: &[[f64; 2]]) -> f64 {
    let mut sum = DoubleDouble::from(0.0);
    for [a, b] in pairs {
        sum = sum + DoubleDouble::from(*a) * DoubleDouble::from(*b);
    }
    sum.value()
}

/// A number with about 31 digits: the sum of two doubles, of which `low` is at most half a unit in
/// the last place of `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

impl DoubleDouble {
    /// The sum of a double and a much smaller one.
    #[inline]
    fn normalized(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self {
            high: sum,
            low: low - (sum - high),
        }
    }

    /// The nearest double.
    #[inline]
    pub const fn value(self) -> f64 {
        self.high
    }

    /// The difference of a double and this number.
    #[inline]
    pub fn error_of(self, computed: f64) -> f64 {
        (computed - self.high) - self.low
    }

    /// The first 22 digits, without zeros at the end, as a program prints a double.
    #[must_use]
    pub fn digits(self) -> String {
        if self.high == 0.0 {
            return "0".to_owned();
        }
        let (sign, mut scaled) = if self.high < 0.0 {
            ("-", -self)
        } else {
            ("", self)
        };
        let mut exponent = libm::floor(libm::log10(scaled.high)) as i32;
        for _ in exponent..21 {
            scaled = scaled * Self::from(10.0);
        }
        // Just below a power of ten the logarithm is rounded up.
        if (scaled - Self::from(1e21)).high < 0.0 {
            scaled = scaled * Self::from(10.0);
            exponent -= 1;
        }
        // A double of 22 digits is a whole number.
        let whole = scaled.high as i128 + scaled.low.round() as i128;
        let digits = whole.to_string();
        let point = exponent + digits.len() as i32 - 21;
        let (digits, length) = (digits.trim_end_matches('0'), digits.len() as i32);
        let count = digits.len() as i32;
        match point {
            _ if point > length || point < -4 => {
                let (first, rest) = digits.split_at(1);
                let dot = if rest.is_empty() { "" } else { "." };
                format!("{sign}{first}{dot}{rest}e{}", point - 1)
            }
            1.. if count <= point => {
                format!("{sign}{digits}{}", "0".repeat((point - count) as usize))
            }
            1.. => {
                let (whole, rest) = digits.split_at(point as usize);
                format!("{sign}{whole}.{rest}")
            }
            _ => format!("{sign}0.{}{digits}", "0".repeat(-point as usize)),
        }
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
        let root = self.high.sqrt();
        if root == 0.0 {
            return Self::from(0.0);
        }
        let rest = self - Self::from(root) * Self::from(root);
        Self::normalized(root, rest.high / (2.0 * root))
    }
}

impl From<f64> for DoubleDouble {
    #[inline]
    fn from(number: f64) -> Self {
        Self {
            high: number,
            low: 0.0,
        }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        let high = sum_with_error(self.high, other.high);
        let low = sum_with_error(self.low, other.low);
        let sum = Self::normalized(high.sum, high.error + low.sum);
        Self::normalized(sum.high, sum.low + low.error)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
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
    #[inline]
    fn mul(self, other: Self) -> Self {
        let high = self.high * other.high;
        let error = self.high.mul_add(other.high, -high);
        let crosswise = self.high * other.low + self.low * other.high;
        Self::normalized(high, error + crosswise)
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    /// Long division with three digits, each of which is a double. A quotient beyond all doubles
    /// is infinite.
    #[inline]
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        if first.is_infinite() {
            return Self::from(first);
        }
        let rest = self - other * Self::from(first);
        let second = rest.high / other.high;
        let rest = rest - other * Self::from(second);
        let third = rest.high / other.high;
        let quotient = Self::normalized(first, second);
        Self::normalized(quotient.high, quotient.low + third)
    }
}
