//! `RoundedInterval`: a measured number beside half of its interval of 95 %, without the digits that nobody knows.

use std::fmt;

/// The most significant digits of a number.
const MAX_DIGITS: i32 = 3;

/// A number and half of its interval, `0.87 ± 0.02`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundedInterval {
    value: f64,
    /// With one significant digit, rounded up.
    half: f64,
    /// The digits behind the point.
    places: usize,
}

impl RoundedInterval {
    /// A number with an interval of this half width around it. An interval that is so narrow that the number
    /// would have more than three digits is shown as wide as the last of them.
    pub fn around(value: f64, half_width: f64) -> Self {
        let least = if value == 0.0 {
            half_width
        } else {
            libm::pow(10.0, (power(value.abs()) + 1 - MAX_DIGITS).into())
        };
        let half_width = half_width.max(least);
        let mut unit = libm::pow(10.0, power(half_width).into());
        // Rounding up is not to carry 2.0000000000000004 to 3.
        let mut digit = libm::ceil(half_width / unit - 1e-9);
        if digit >= 10.0 {
            (digit, unit) = (1.0, 10.0 * unit);
        }
        let places = if half_width > 0.0 && half_width.is_finite() {
            (-power(unit * 1.5)).max(0) as usize
        } else {
            (digit, unit) = (0.0, 1.0);
            0
        };
        Self {
            // Not "-0.00".
            value: libm::round(value / unit) * unit + 0.0,
            half: digit * unit,
            places,
        }
    }

    /// Half of the interval, rounded up.
    pub fn half(&self) -> String {
        format!("{:.1$}", self.half, self.places)
    }

    /// A number in an interval; of two unequal sides, the longer one counts.
    pub fn within(value: f64, low: f64, high: f64) -> Self {
        Self::around(value, (value - low).max(high - value))
    }
}

/// A number in an interval as a mantissa and a power of ten; 0 has the power 0.
pub fn mantissa(value: f64, low: f64, high: f64) -> (RoundedInterval, i32) {
    if value == 0.0 {
        return (RoundedInterval::within(value, low, high), 0);
    }
    let power = power(value.abs());
    let [value, low, high] = [value, low, high].map(|end| end / libm::pow(10.0, power.into()));
    (RoundedInterval::within(value, low, high), power)
}

/// The power of ten of the first digit.
fn power(number: f64) -> i32 {
    libm::floor(libm::log10(number)) as i32
}

impl fmt::Display for RoundedInterval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            value,
            half,
            places,
        } = self;
        write!(f, "{value:.places$} ± {half:.places$}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_digit_is_shown_that_is_not_sure() {
        for (value, half, expected) in [
            (0.8712, 0.0123, "0.87 ± 0.02"),
            (0.8712, 0.02, "0.87 ± 0.02"),
            (0.8712, 0.0951, "0.9 ± 0.1"),
            (-0.4996, 0.000_01, "-0.500 ± 0.001"),
            (-0.001, 0.04, "0.00 ± 0.04"),
            (13.37, 0.3, "13.4 ± 0.3"),
            (1234.0, 57.0, "1230 ± 60"),
            (0.0, 0.0, "0 ± 0"),
        ] {
            assert_eq!(RoundedInterval::around(value, half).to_string(), expected);
        }
        let sides = RoundedInterval::within(2.0, 1.9, 2.4);
        assert_eq!(sides.to_string(), "2.0 ± 0.4");
        let (rounded, power) = mantissa(2.5e-11, 2.4e-11, 2.6e-11);
        assert_eq!((rounded.to_string().as_str(), power), ("2.5 ± 0.1", -11));
    }
}
