//! `Bound`: how far a computed outcome may be from the exact one.

use std::fmt;

use super::Outcome;

/// How far a computed outcome may be from the exact one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Bound {
    /// The outcomes are equal.
    #[default]
    Equal,
    /// At most this many units in the last place of the exact number, or of the
    /// greatest of three numbers.
    Ulps(f64),
    /// At most this distance.
    Absolute(f64),
}

impl Bound {
    /// Whether an outcome is so near to the exact one.
    pub(super) fn admits(self, exact: Outcome, outcome: Outcome) -> bool {
        let greatest_distance = match self {
            Self::Equal => return exact == outcome,
            Self::Ulps(ulps) => ulps * ulp(exact.magnitude()),
            Self::Absolute(bound) => bound,
        };
        let distance = exact.distance(&outcome);
        exact == outcome || distance.is_some_and(|distance| distance <= greatest_distance)
    }
}

impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Equal => f.write_str("equal"),
            Self::Ulps(ulps) if *ulps < 1e4 => write!(f, "{ulps} ulp"),
            Self::Ulps(ulps) => write!(f, "{ulps:.1e} ulp"),
            Self::Absolute(bound) => write!(f, "{bound:.1e}"),
        }
    }
}

/// The distance between a number and the next greater one.
#[must_use]
pub fn ulp(number: f64) -> f64 {
    number.abs().next_up() - number.abs()
}

/// The error of an outcome, for a reader.
pub(super) fn error(exact: Outcome, outcome: Outcome) -> String {
    let ulps = |distance: f64| distance / ulp(exact.magnitude());
    match exact.distance(&outcome) {
        _ if exact == outcome => "0".to_owned(),
        Some(distance) if ulps(distance) < 1e4 => format!("{:.0} ulp", ulps(distance)),
        Some(distance) => format!("{distance:.1e}"),
        None => "wrong".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_and_numbers_are_short() {
        let shown = |ulps: f64| error(1.0.into(), (1.0 + ulps * f64::EPSILON).into());
        let all = [0.0, 3.0, 9999.0, 10_000.0].map(shown);
        assert_eq!(all, ["0", "3 ulp", "9999 ulp", "2.2e-12"]);
        let triple = |x: f64| Outcome::Triple([0.5, x, -4.0]);
        let off = error(triple(1.0), triple(1.0 + 8.0 * f64::EPSILON));
        assert_eq!(off, "2 ulp", "of the greatest number");
        assert_eq!(error(Outcome::Nothing, Outcome::Nothing), "0");
        assert_eq!(error(Outcome::Nothing, Outcome::Refused), "wrong");
        let numbers = [0.0, 1e-5, 9e-6, 1e15, 1e16, -2.5, f64::NAN];
        let shown = numbers.map(|number| Outcome::from(number).to_string());
        assert_eq!(
            shown.join(" "),
            "0 0.00001 9e-6 1000000000000000 1e16 -2.5 NaN"
        );
    }
}
