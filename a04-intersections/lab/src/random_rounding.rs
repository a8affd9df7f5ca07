//! `RandomlyRounded`: doubles whose operations are rounded up or down at random.
//!
//! Run several times, a computation then shows its own rounding errors: the digits in which the runs
//! differ are noise (J. Vignes, "A stochastic arithmetic for reliable scientific computation",
//! Mathematics and Computers in Simulation 35, 1993, section 2).

use std::cell::Cell;
use std::ops::{Add, Div, Mul, Neg, Sub};

use a02_lab::exact::sum_with_error;

use crate::number::Number;

/// A double. The result of an operation is one of the two doubles beside the exact one, each as often
/// as the other, or the exact one where that is a double.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RandomlyRounded(f64);

thread_local! {
    /// The state of the random numbers, never 0.
    static STATE: Cell<u64> = const { Cell::new(1) };
}

impl RandomlyRounded {
    /// Starts the random roundings of this thread anew.
    pub fn seed(seed: u64) {
        // Spread over all digits; the last one keeps it from being 0.
        STATE.set(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    }

    pub const fn value(self) -> f64 {
        self.0
    }

    /// One of the doubles beside the sum of the nearest double and an error, of which the sign counts.
    fn between(nearest: f64, error: f64) -> Self {
        let is_exact = error == 0.0 || error.is_nan();
        if is_exact || is_heads() {
            Self(nearest)
        } else if error > 0.0 {
            Self(nearest.next_up())
        } else {
            Self(nearest.next_down())
        }
    }
}

/// A random decision (G. Marsaglia, "Xorshift RNGs", Journal of Statistical Software 8(14), 2003).
fn is_heads() -> bool {
    let mut state = STATE.get();
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    STATE.set(state);
    state & (1 << 40) != 0
}

impl Number for RandomlyRounded {
    fn of(number: f64) -> Self {
        Self(number)
    }

    fn sqrt(self) -> Self {
        let root = self.0.sqrt();
        Self::between(root, fused(-root, root, self.0))
    }
}

impl Add for RandomlyRounded {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let rounded = sum_with_error(self.0, other.0);
        Self::between(rounded.sum, rounded.error)
    }
}

impl Sub for RandomlyRounded {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for RandomlyRounded {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Mul for RandomlyRounded {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = self.0 * other.0;
        Self::between(product, fused(self.0, other.0, -product))
    }
}

impl Div for RandomlyRounded {
    type Output = Self;

    /// The remainder of the dividend has the sign of the quotient's error times the divisor.
    fn div(self, other: Self) -> Self {
        let quotient = self.0 / other.0;
        let rest = fused(-quotient, other.0, self.0);
        Self::between(quotient, rest * other.0.signum())
    }
}

/// `a b + c`, rounded once.
#[allow(
    clippy::disallowed_methods,
    reason = "one rounding instead of two makes the error exact"
)]
fn fused(a: f64, b: f64, c: f64) -> f64 {
    a.mul_add(b, c)
}
