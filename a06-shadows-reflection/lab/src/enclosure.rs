//! `Enclosure`: interval arithmetic with outward rounding, by which the policy of pbrt 4 tells whether a hit is
//! certain.
//!
//! An end moves outwards only if the operation has rounded it the other way, so that results without rounding stay
//! single numbers: an equality of such numbers is decided, too.
//!
//! The result of an operation holds the exact result for all numbers that its operands hold
//! (R. E. Moore, R. B. Kearfott, M. J. Cloud: Introduction to Interval Analysis, 2009, chapter 2).

use std::ops::{Add, Div, Mul, Neg, Sub};

use a02_lab::exact::{RoundedSum, sum_with_error};
use a04_lab::number::Number;

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
    fn hull(self, other: Self, operation: fn(f64, f64) -> Rounded) -> Self {
        let mut hull: Option<Self> = None;
        for a in [self.low, self.high] {
            for b in [other.low, other.high] {
                let result = operation(a, b);
                if result.value.is_nan() {
                    return Self::EVERYTHING;
                }
                let (low, high) = (result.below(), result.above());
                hull = Some(match hull {
                    Some(hull) => Self {
                        low: hull.low.min(low),
                        high: hull.high.max(high),
                    },
                    None => Self { low, high },
                });
            }
        }
        hull.unwrap_or(Self::EVERYTHING)
    }

    /// Whether 0 is the only number.
    pub fn is_zero(self) -> bool {
        self.low == 0.0 && self.high == 0.0
    }
}

/// A rounded result, and on which side of it the exact one lies.
#[derive(Clone, Copy)]
struct Rounded {
    value: f64,
    /// The exact result less the rounded one, or a number of the same sign; NaN if it is not known.
    rest: f64,
}

/// Below this magnitude a rest may vanish.
const LEAST: f64 = 1e-280;

impl Rounded {
    /// A result whose rest is right unless one of these magnitudes is too small or not finite.
    fn new(value: f64, rest: f64, magnitudes: [f64; 2]) -> Self {
        let is_known = magnitudes
            .into_iter()
            .all(|x| x == 0.0 || (LEAST..f64::INFINITY).contains(&x.abs()));
        Self {
            value,
            rest: if is_known { rest } else { f64::NAN },
        }
    }

    /// A number that is not above the exact result.
    fn below(self) -> f64 {
        if self.rest >= 0.0 {
            self.value
        } else {
            self.value.next_down()
        }
    }

    /// A number that is not below the exact result.
    fn above(self) -> f64 {
        if self.rest <= 0.0 {
            self.value
        } else {
            self.value.next_up()
        }
    }
}

/// Sums are exact below the range of normal numbers, too.
fn sum(a: f64, b: f64) -> Rounded {
    let RoundedSum { sum, error } = sum_with_error(a, b);
    Rounded {
        value: sum,
        rest: if sum.is_finite() { error } else { f64::NAN },
    }
}

#[allow(
    clippy::disallowed_methods,
    reason = "one rounding instead of two gives the exact rest"
)]
fn product(a: f64, b: f64) -> Rounded {
    let product = a * b;
    if a == 0.0 || b == 0.0 {
        return Rounded {
            value: product,
            rest: 0.0,
        };
    }
    // A product that is rounded to 0 is not known, as a magnitude of 0 would be.
    let magnitude = if product == 0.0 { f64::NAN } else { product };
    Rounded::new(product, a.mul_add(b, -product), [magnitude, product])
}

#[allow(
    clippy::disallowed_methods,
    reason = "one rounding instead of two gives the exact rest"
)]
fn quotient(a: f64, b: f64) -> Rounded {
    let quotient = a / b;
    if a == 0.0 {
        return Rounded {
            value: quotient,
            rest: 0.0,
        };
    }
    let rest = (-quotient).mul_add(b, a) * b.signum();
    let magnitude = if quotient == 0.0 { f64::NAN } else { quotient };
    Rounded::new(quotient, rest, [a, magnitude])
}

#[allow(
    clippy::disallowed_methods,
    reason = "one rounding instead of two gives the exact rest"
)]
fn root(x: f64) -> Rounded {
    let root = x.sqrt();
    Rounded::new(root, (-root).mul_add(root, x), [x, root])
}

impl Number for Enclosure {
    fn of(number: f64) -> Self {
        number.into()
    }

    fn sqrt(self) -> Self {
        Self {
            low: root(self.low.max(0.0)).below(),
            high: root(self.high).above(),
        }
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
            Self {
                low: sum(self.low, other.low).below(),
                high: sum(self.high, other.high).above(),
            }
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
        self.hull(other, product)
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
        self.hull(other, quotient)
    }
}
