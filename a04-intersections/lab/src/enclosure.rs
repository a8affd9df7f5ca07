//! `Enclosure`: interval arithmetic with outward rounding, which proves what rounding leaves open.
//!
//! The result of an operation holds the exact result for all numbers that its operands hold
//! (R. E. Moore, R. B. Kearfott, M. J. Cloud: Introduction to Interval Analysis, 2009, chapter 2).

use std::ops::{Add, Div, Mul, Neg, Sub};

/// All numbers from `low` to `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enclosure {
    pub low: f64,
    pub high: f64,
}

impl Enclosure {
    pub const EVERYTHING: Self = Self {
        low: f64::NEG_INFINITY,
        high: f64::INFINITY,
    };

    /// The numbers between rounded ends, which are off by less than one unit in the last place.
    fn outwards(low: f64, high: f64) -> Self {
        Self {
            low: low.next_down(),
            high: high.next_up(),
        }
    }

    /// Whether all numbers are above 0 (true) or below (false); `None` if it is open.
    pub fn sign(self) -> Option<bool> {
        if self.low > 0.0 {
            Some(true)
        } else if self.high < 0.0 {
            Some(false)
        } else {
            None
        }
    }

    /// From the least to the greatest result of the ends.
    fn hull(self, other: Self, operation: fn(f64, f64) -> f64) -> Self {
        let [a, b] = [other.low, other.high].map(|end| operation(self.low, end));
        let [c, d] = [other.low, other.high].map(|end| operation(self.high, end));
        // `min` and `max` drop a NaN.
        if (a + b + c + d).is_nan() {
            return Self::EVERYTHING;
        }
        Self::outwards(a.min(b).min(c).min(d), a.max(b).max(c).max(d))
    }

    /// The greater of two numbers, of which each lies in one of the enclosures.
    #[must_use]
    pub const fn max(self, other: Self) -> Self {
        Self {
            low: self.low.max(other.low),
            high: self.high.max(other.high),
        }
    }

    /// The smaller of two numbers, of which each lies in one of the enclosures.
    #[must_use]
    pub const fn min(self, other: Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.min(other.high),
        }
    }

    fn is_zero(self) -> bool {
        self.low == 0.0 && self.high == 0.0
    }

    /// The root of numbers that are not negative.
    #[must_use]
    pub fn sqrt(self) -> Self {
        Self::outwards(self.low.max(0.0).sqrt(), self.high.sqrt())
    }
}

impl From<f64> for Enclosure {
    fn from(number: f64) -> Self {
        Self {
            low: number,
            high: number,
        }
    }
}

impl Add for Enclosure {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        // A sum with 0 is exact.
        if self.is_zero() {
            other
        } else if other.is_zero() {
            self
        } else {
            Self::outwards(self.low + other.low, self.high + other.high)
        }
    }
}

impl Sub for Enclosure {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        // The difference of two equal doubles is exact.
        if self == other && self.low == self.high {
            return Self::from(0.0);
        }
        self + -other
    }
}

impl Neg for Enclosure {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            low: -self.high,
            high: -self.low,
        }
    }
}

impl Mul for Enclosure {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::from(0.0);
        }
        self.hull(other, Mul::mul)
    }
}

/// By numbers that may be 0, everything.
impl Div for Enclosure {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        if other.sign().is_none() {
            return Self::EVERYTHING;
        }
        if self.is_zero() {
            return self;
        }
        self.hull(other, Div::div)
    }
}
