//! Checks of the arguments of constructors, and the one error type they share.
//!
//! Lengths and coordinates stay within [`MIN_LENGTH`] and
//! [`MAX_LENGTH`], so that a product of three of them neither overflows
//! nor underflows, and no formula of the workbook yields infinity or NaN.

use std::fmt;

use crate::{Color, text};

/// Shortest length that a constructor accepts.
pub const MIN_LENGTH: f64 = 1e-100;

/// Greatest length, and greatest magnitude of a coordinate, that a constructor
/// accepts.
pub const MAX_LENGTH: f64 = 1e100;

/// Greatest channel of a colour that a constructor accepts. With it, light times the
/// colour of a material is finite, even squared for an error estimate and summed over
/// lights and samples.
pub const MAX_CHANNEL: f64 = 1e50;

/// An argument outside of the range that its constructor accepts.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{name} is {value}, but must be {allowed}")]
pub struct ArgumentError {
    /// The name of the argument in the constructor.
    pub name: &'static str,
    /// The value that was given.
    pub value: String,
    /// The values that are accepted.
    pub allowed: &'static str,
}

impl ArgumentError {
    /// An error that names the argument, its value and the allowed values. A number with a
    /// fraction is given as [`text::number`].
    pub fn new(name: &'static str, value: impl fmt::Display, allowed: &'static str) -> Self {
        Self {
            name,
            value: format!("{value}"),
            allowed,
        }
    }
}

/// Returns `value` if it is `valid`, else an error that names the allowed values.
pub fn check(
    name: &'static str,
    value: f64,
    valid: bool,
    allowed: &'static str,
) -> Result<f64, ArgumentError> {
    let valid = valid.then_some(value);
    valid.ok_or_else(|| ArgumentError::new(name, text::number(value), allowed))
}

/// A finite number.
pub fn finite(name: &'static str, value: f64) -> Result<f64, ArgumentError> {
    check(name, value, value.is_finite(), "a finite number")
}

/// A finite number that is not negative.
pub fn not_negative(name: &'static str, value: f64) -> Result<f64, ArgumentError> {
    let valid = value.is_finite() && value >= 0.0;
    check(name, value, valid, "a finite number of at least 0")
}

/// A positive length within the range for which the formulas hold.
pub fn length(name: &'static str, value: f64) -> Result<f64, ArgumentError> {
    let valid = (MIN_LENGTH..=MAX_LENGTH).contains(&value);
    check(name, value, valid, "a length from 1e-100 to 1e100")
}

/// A coordinate within the range for which the formulas hold.
pub fn coordinate(name: &'static str, value: f64) -> Result<f64, ArgumentError> {
    let valid = value.abs() <= MAX_LENGTH;
    check(name, value, valid, "a coordinate from -1e100 to 1e100")
}

/// A colour within the range for which the formulas hold, no channel negative.
pub fn color(name: &'static str, value: Color) -> Result<Color, ArgumentError> {
    let valid = |channel: &f64| (0.0..=MAX_CHANNEL).contains(channel);
    check_channels(name, value, valid, "a colour of channels from 0 to 1e50")
}

/// A fraction of each channel, from 0 to 1.
pub fn fraction(name: &'static str, value: Color) -> Result<Color, ArgumentError> {
    let valid = |channel: &f64| (0.0..=1.0).contains(channel);
    check_channels(name, value, valid, "a fraction from 0 to 1 of each channel")
}

fn check_channels(
    name: &'static str,
    value: Color,
    valid: impl Fn(&f64) -> bool,
    allowed: &'static str,
) -> Result<Color, ArgumentError> {
    let given = || format!("({})", text::numbers(&value.channels()));
    let valid = value.channels().iter().all(valid).then_some(value);
    valid.ok_or_else(|| ArgumentError::new(name, given(), allowed))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_include_their_ends_and_nothing_beyond() {
        type Check = fn(&'static str, f64) -> Result<f64, ArgumentError>;
        let ranges: [(Check, [f64; 2], [f64; 2]); 4] = [
            (
                finite,
                [-f64::MAX, f64::MAX],
                [f64::NEG_INFINITY, f64::INFINITY],
            ),
            (not_negative, [0.0, f64::MAX], [-1e-300, f64::INFINITY]),
            (length, [1e-100, 1e100], [0.999e-100, 1.001e100]),
            (coordinate, [-1e100, 1e100], [-1.001e100, 1.001e100]),
        ];
        for (check, ends, beyond) in ranges {
            for end in ends {
                assert_eq!(check("x", end), Ok(end));
            }
            for bad in [beyond[0], beyond[1], f64::NAN] {
                assert!(check("x", bad).is_err(), "{bad}");
            }
        }
        for (check, most) in [(color as fn(_, _) -> Result<_, _>, 1e50), (fraction, 1.0)] {
            for good in [0.0, most] {
                let good = Color::new(0.25, good, 0.5);
                assert_eq!(check("x", good), Ok(good));
            }
            for bad in [-1e-9, 1.001 * most, f64::NAN, f64::INFINITY] {
                assert!(check("x", Color::new(0.0, bad, 0.0)).is_err(), "{bad}");
            }
        }
        let error = length("radius", 0.0).unwrap_err().to_string();
        let text = "radius is 0, but must be a length from 1e-100 to 1e100";
        assert_eq!(error, text);
    }
}
