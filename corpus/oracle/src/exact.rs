//! `Surd`: numbers `a + b √d` of exact rationals, which the roots of quadratic equations are.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// An exact rational number.
pub type Q = BigRational;
/// Three of them.
pub type Q3 = [Q; 3];

/// The rational that a finite double is.
///
/// # Panics
///
/// If the number is infinite or NaN, which the reader's caller excludes.
pub fn exact(number: f64) -> Q {
    Q::from_float(number).expect("a finite number")
}

/// `2^power`.
pub fn power_of_two(power: i32) -> Q {
    let magnitude = Q::from_integer(BigInt::one() << power.unsigned_abs());
    if power < 0 {
        magnitude.recip()
    } else {
        magnitude
    }
}

/// The scalar product.
pub fn dot(a: &Q3, b: &Q3) -> Q {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// The vector product.
pub fn cross(a: &Q3, b: &Q3) -> Q3 {
    [
        &a[1] * &b[2] - &a[2] * &b[1],
        &a[2] * &b[0] - &a[0] * &b[2],
        &a[0] * &b[1] - &a[1] * &b[0],
    ]
}

/// `a - b`.
pub fn difference(a: &Q3, b: &Q3) -> Q3 {
    [&a[0] - &b[0], &a[1] - &b[1], &a[2] - &b[2]]
}

/// `a + b √d`, with `d` not negative.
#[derive(Clone, Debug)]
pub struct Surd {
    pub a: Q,
    pub b: Q,
    pub d: Q,
}

impl Surd {
    /// A rational number.
    pub fn rational(a: Q) -> Self {
        Self {
            a,
            b: Q::zero(),
            d: Q::zero(),
        }
    }

    /// `offset + factor · self`.
    pub fn scaled(&self, offset: &Q, factor: &Q) -> Self {
        Self {
            a: offset + factor * &self.a,
            b: factor * &self.b,
            d: self.d.clone(),
        }
    }

    /// The exact sign: -1, 0 or 1.
    pub fn sign(&self) -> i32 {
        let [a, b] = [sign_of(&self.a), sign_of(&(&self.b * &self.d))];
        if a == b || b == 0 {
            return a;
        }
        if a == 0 {
            return b;
        }
        // Of opposite signs: the greater square decides.
        let [a_squared, b_squared] = [&self.a * &self.a, &self.b * &self.b * &self.d];
        match a_squared.cmp(&b_squared) {
            Ordering::Greater => a,
            Ordering::Less => b,
            Ordering::Equal => 0,
        }
    }

    /// Whether this number is above another one, below it, or equal to it.
    pub fn compare(&self, other: &Q) -> Ordering {
        self.scaled(&-other, &Q::one()).sign().cmp(&0)
    }

    /// An approximation by a rational, whose error is below `2^-bits` of the root.
    pub fn approximate(&self, bits: u32) -> Q {
        &self.a + &self.b * root(&self.d, bits)
    }
}

fn sign_of(number: &Q) -> i32 {
    if number.is_zero() {
        0
    } else if number.is_negative() {
        -1
    } else {
        1
    }
}

/// The square root, rounded down, with an error below `2^-bits` of itself.
pub fn root(number: &Q, bits: u32) -> Q {
    if number.is_zero() {
        return Q::zero();
    }
    // √(n / d) = √(n d) / d. Shifted to the left by an even number of bits, so that the integer root has
    // at least as many digits as are asked for.
    let product = number.numer() * number.denom();
    let shift = bits + 2;
    let shifted: BigInt = product << (2 * shift);
    Q::new(shifted.sqrt(), number.denom() << shift)
}

/// A number to 40 significant digits, for an approximation with many more.
///
/// Two approximations of different accuracy have to agree: then both are right.
pub fn digits(approximate: impl Fn(u32) -> Q) -> String {
    let mut bits = 512;
    loop {
        let [one, other] = [bits, 2 * bits].map(|bits| decimal(&approximate(bits)));
        if one == other {
            return one;
        }
        bits *= 2;
    }
}

/// How many significant digits the file has.
const DIGITS: i32 = 40;

/// A rational to 40 significant digits, without zeros at their end.
fn decimal(number: &Q) -> String {
    if number.is_zero() {
        return "0".to_owned();
    }
    let sign = if number.is_negative() { "-" } else { "" };
    let magnitude = number.abs();
    let mut exponent = estimate(&magnitude);
    while ten_to(exponent) > magnitude {
        exponent -= 1;
    }
    while ten_to(exponent + 1) <= magnitude {
        exponent += 1;
    }
    let mut scaled = (magnitude * ten_to(DIGITS - 1 - exponent))
        .round()
        .to_integer();
    if scaled == ten_to(DIGITS).to_integer() {
        scaled /= 10;
        exponent += 1;
    }
    let text = scaled.to_string();
    let text = text.trim_end_matches('0');
    format!("{sign}{}", placed(text, exponent))
}

/// Digits of which the first has the place `exponent`, as a number.
fn placed(digits: &str, exponent: i32) -> String {
    let length = digits.len() as i32;
    if (0..21).contains(&exponent) {
        let whole = exponent + 1;
        if length <= whole {
            return format!("{digits}{}", "0".repeat((whole - length) as usize));
        }
        let (whole, fraction) = digits.split_at(whole as usize);
        return format!("{whole}.{fraction}");
    }
    if (-5..0).contains(&exponent) {
        return format!("0.{}{digits}", "0".repeat((-1 - exponent) as usize));
    }
    let (first, rest) = digits.split_at(1);
    if rest.is_empty() {
        format!("{first}e{exponent}")
    } else {
        format!("{first}.{rest}e{exponent}")
    }
}

/// About the decimal exponent of a positive number.
fn estimate(number: &Q) -> i32 {
    let bits = number.numer().bits() as f64 - number.denom().bits() as f64;
    (bits * std::f64::consts::LOG10_2).floor() as i32
}

fn ten_to(power: i32) -> Q {
    let magnitude = Q::from_integer(BigInt::from(10).pow(power.unsigned_abs()));
    if power < 0 {
        magnitude.recip()
    } else {
        magnitude
    }
}

/// The double nearest to a number, by way of its digits.
pub fn double(number: &Q) -> f64 {
    decimal(number).parse().unwrap_or(f64::NAN)
}
