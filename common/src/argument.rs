//! Checks of the arguments of constructors, and the one error type they share.
//!
//! Lengths and coordinates stay within [`SMALLEST_LENGTH`] and
//! [`LARGEST_LENGTH`], so that a product of three of them neither overflows
//! nor underflows, and no formula of the workbook yields infinity or NaN.

use std::fmt;

use crate::Color;

/// Shortest length that a constructor accepts.
pub const SMALLEST_LENGTH: f64 = 1e-100;

/// Greatest length, and greatest magnitude of a coordinate, that a constructor
/// accepts.
pub const LARGEST_LENGTH: f64 = 1e100;

/// Greatest channel of a colour that a constructor accepts. With it, light times the
/// colour of a material is finite, even squared for an error estimate and summed over
/// lights and samples.
pub const LARGEST_CHANNEL: f64 = 1e50;

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
    /// An error that names the argument, its value and the allowed values.
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
    if valid {
        Ok(value)
    } else {
        Err(ArgumentError::new(name, value, allowed))
    }
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
    let valid = (SMALLEST_LENGTH..=LARGEST_LENGTH).contains(&value);
    check(name, value, valid, "a length from 1e-100 to 1e100")
}

/// A coordinate within the range for which the formulas hold.
pub fn coordinate(name: &'static str, value: f64) -> Result<f64, ArgumentError> {
    let valid = value.abs() <= LARGEST_LENGTH;
    check(name, value, valid, "a coordinate from -1e100 to 1e100")
}

/// A colour within the range for which the formulas hold, no channel negative.
pub fn color(name: &'static str, value: Color) -> Result<Color, ArgumentError> {
    let valid = |channel: &f64| (0.0..=LARGEST_CHANNEL).contains(channel);
    check_channels(name, value, valid, "a colour of channels from 0 to 1e50")
}

/// A share of each channel, from 0 to 1.
pub fn share(name: &'static str, value: Color) -> Result<Color, ArgumentError> {
    let valid = |channel: &f64| (0.0..=1.0).contains(channel);
    check_channels(name, value, valid, "a share from 0 to 1 of each channel")
}

fn check_channels(
    name: &'static str,
    value: Color,
    valid: impl Fn(&f64) -> bool,
    allowed: &'static str,
) -> Result<Color, ArgumentError> {
    if value.channels().iter().all(valid) {
        Ok(value)
    } else {
        let given = format!("({}, {}, {})", value.r, value.g, value.b);
        Err(ArgumentError::new(name, given, allowed))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_names_the_value_and_the_allowed_ones() {
        let error = length("radius", 0.0).unwrap_err();
        let text = "radius is 0, but must be a length from 1e-100 to 1e100";
        assert_eq!(error.to_string(), text);
    }

    #[test]
    fn no_check_lets_nan_or_infinity_pass() {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(finite("x", value).is_err());
            assert!(not_negative("x", value).is_err());
            assert!(length("x", value).is_err());
            assert!(coordinate("x", value).is_err());
            assert!(color("x", Color::new(0.0, value, 0.0)).is_err());
        }
    }

    #[test]
    fn ranges_include_their_ends_and_nothing_beyond() {
        assert!(length("x", 1e-100).is_ok() && length("x", 1e100).is_ok());
        assert!(length("x", 0.999e-100).is_err() && length("x", 1.001e100).is_err());
        assert!(length("x", -1.0).is_err());
        assert!(coordinate("x", -1e100).is_ok() && coordinate("x", 1e100).is_ok());
        assert!(coordinate("x", -1.001e100).is_err() && coordinate("x", 1.001e100).is_err());
        assert!(not_negative("x", 0.0).is_ok() && not_negative("x", -1e-300).is_err());
        assert!(finite("x", -7.0).is_ok());
        assert!(color("x", Color::WHITE).is_ok());
        assert!(color("x", Color::new(0.0, -0.1, 0.0)).is_err());
        assert!(color("x", Color::gray(1e50)).is_ok());
        assert!(color("x", Color::new(0.0, 0.0, 1.001e50)).is_err());
        assert!(share("x", Color::WHITE).is_ok() && share("x", Color::BLACK).is_ok());
        assert!(share("x", Color::new(0.0, 1.001, 0.0)).is_err());
        assert!(share("x", Color::gray(-1e-9)).is_err());
    }

    #[test]
    fn valid_values_pass_unchanged() {
        for number in [0.25, 7.0] {
            let checks = [finite, not_negative, length, coordinate];
            assert!(checks.iter().all(|check| check("x", number) == Ok(number)));
        }
        let orange = Color::new(1.0, 0.5, 0.0);
        assert_eq!(color("x", orange), Ok(orange));
        assert_eq!(share("x", orange), Ok(orange));
    }
}
