//! `RecordedPoint`: a line of a recording.

use std::cmp::Ordering;

/// A point of a curve.
#[derive(Debug)]
pub struct RecordedPoint<'t> {
    /// With its stage, such as `a04.sphere-far`.
    pub experiment: &'t str,
    /// The name of its method.
    pub method: &'t str,
    /// The value of the parameter.
    pub parameter: f64,
    /// The unit of the error.
    pub unit: &'t str,
    /// The root mean square error, or the fraction of wrong answers.
    pub error: Measurement,
    /// The time of a run.
    pub seconds: Measurement,
    /// The slope of the curve, if it is a power law.
    pub slope: Option<Measurement>,
    /// All of it.
    pub(super) line: &'t str,
}

/// A number with its interval of 95 %.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measurement {
    /// The number.
    pub value: f64,
    /// The lower end of the interval.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

impl Measurement {
    fn parse([value, low, high]: [&str; 3]) -> Option<Self> {
        Some(Self {
            value: value.parse().ok()?,
            low: low.parse().ok()?,
            high: high.parse().ok()?,
        })
    }

    /// Over a number without an interval.
    pub fn over(self, divisor: f64) -> Self {
        Self {
            value: self.value / divisor,
            low: self.low / divisor,
            high: self.high / divisor,
        }
    }

    /// One over it.
    pub fn inverse(self) -> Self {
        Self {
            value: 1.0 / self.value,
            low: 1.0 / self.high,
            high: 1.0 / self.low,
        }
    }

    /// On which side of 1 it lies for sure; none if it may lie on both.
    pub fn sign(self) -> Option<Ordering> {
        if self.low > 1.0 {
            Some(Ordering::Greater)
        } else if self.high < 1.0 {
            Some(Ordering::Less)
        } else {
            None
        }
    }
}

impl<'t> RecordedPoint<'t> {
    /// A row as [`csv`](crate::report::csv) writes it, with method and unit in quotes.
    pub fn parse(line: &'t str) -> Option<Self> {
        let parts: Vec<_> = line.split('"').collect();
        let [experiment, method, parameter_and_work, unit, numbers] = parts[..] else {
            return None;
        };
        let (parameter, _) = parameter_and_work.strip_prefix(',')?.split_once(',')?;
        let numbers: Vec<_> = numbers.split(',').collect();
        let [
            "",
            e,
            e_low,
            e_high,
            s,
            s_low,
            s_high,
            slope,
            slope_low,
            slope_high,
        ] = numbers[..]
        else {
            return None;
        };
        Some(Self {
            experiment: experiment.strip_suffix(',')?,
            method,
            parameter: parameter.parse().ok()?,
            unit,
            error: Measurement::parse([e, e_low, e_high])?,
            seconds: Measurement::parse([s, s_low, s_high])?,
            slope: Measurement::parse([slope, slope_low, slope_high]),
            line,
        })
    }

    /// Whether it is measured at the same value of the same experiment's parameter.
    pub fn is_at(&self, other: &Self) -> bool {
        self.experiment == other.experiment && self.parameter == other.parameter
    }

    /// Whether its method has this name in lower case, with dashes between its words.
    pub fn has_method(&self, name: &str) -> bool {
        let mut dashed = String::new();
        for letter in self.method.to_lowercase().chars() {
            if letter.is_alphanumeric() {
                dashed.push(letter);
            } else if !dashed.ends_with('-') {
                dashed.push('-');
            }
        }
        dashed.trim_matches('-') == name
    }
}
