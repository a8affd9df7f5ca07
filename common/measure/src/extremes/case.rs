//! `Case`: a row of the table of extreme cases.

use std::fmt;

use super::bound::error;
use super::{Bound, Outcome};

/// A row of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// A letter for the subject and a number.
    pub id: &'static str,
    /// The quantity that is computed, and its arguments.
    pub what: String,
    exact: Outcome,
    bound: Bound,
    protocol: Option<(Outcome, Protocol)>,
    ours: Outcome,
}

/// Whether the protocol's formula is expected to hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Protocol {
    /// Its error is within the bound, too.
    Holds,
    /// Its error is larger.
    Fails,
}

impl Case {
    /// A row that compares `ours` with an `exact` outcome from elsewhere.
    pub fn new(
        id: &'static str,
        what: impl Into<String>,
        exact: impl Into<Outcome>,
        bound: Bound,
        ours: impl Into<Outcome>,
    ) -> Self {
        Self {
            id,
            what: what.into(),
            exact: exact.into(),
            bound,
            protocol: None,
            ours: ours.into(),
        }
    }

    /// Adds the outcome of the protocol's formula.
    #[must_use]
    pub fn protocol(mut self, says: Protocol, outcome: impl Into<Outcome>) -> Self {
        self.protocol = Some((outcome.into(), says));
        self
    }

    /// Whether our outcome is within the bound, and the protocol's is or is not, as
    /// expected.
    #[must_use]
    pub fn holds(&self) -> bool {
        let as_said = self.protocol.is_none_or(|(outcome, says)| {
            self.bound.admits(self.exact, outcome) == (says == Protocol::Holds)
        });
        as_said && self.bound.admits(self.exact, self.ours)
    }

    /// The exact outcome, ours, and the error of ours, in one line.
    #[must_use]
    pub fn comparison(&self) -> String {
        let Self {
            exact, ours, bound, ..
        } = self;
        match exact.distance(*ours) {
            Some(_) => {
                let error = error(*exact, *ours);
                format!("expected {exact}, got {ours}, off by {error} (bound: {bound})")
            }
            None => format!("expected {exact}, got {ours}"),
        }
    }
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            id,
            what,
            exact,
            bound,
            protocol,
            ours,
        } = self;
        let verdict = if self.holds() { "ok" } else { "FAILED" };
        writeln!(f, "{id}  {verdict:6}  {what}")?;
        writeln!(f, "     exact     {exact}   (bound: {bound})")?;
        if let Some((outcome, says)) = protocol {
            let says = match says {
                Protocol::Holds => "",
                Protocol::Fails => ", out of bound",
            };
            let error = error(*exact, *outcome);
            writeln!(f, "     protocol  {outcome}   error {error}{says}")?;
        }
        write!(f, "     ours      {ours}   error {}", error(*exact, *ours))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case(bound: Bound, ours: impl Into<Outcome>) -> Case {
        Case::new("A01", "one", 1.0, bound, ours)
    }

    #[test]
    fn bounds_admit_outcomes_within_them() {
        let next = 1.0_f64.next_up();
        assert!(case(Bound::Equal, 1.0).holds());
        assert!(!case(Bound::Equal, next).holds());
        assert!(case(Bound::Ulps(1.0), next).holds());
        assert!(!case(Bound::Ulps(1.0), next.next_up()).holds());
        assert!(case(Bound::Absolute(0.5), 1.5).holds());
        assert!(!case(Bound::Absolute(0.5), 1.6).holds());
        assert!(case(Bound::Finite, 1e300).holds());
        assert!(case(Bound::Finite, Outcome::Nothing).holds());
        let nothing = |bound| Case::new("", "", Outcome::Nothing, bound, Outcome::Nothing);
        assert!(nothing(Bound::Ulps(1.0)).holds() && nothing(Bound::Absolute(1.0)).holds());
    }

    #[test]
    fn nan_and_infinity_are_within_no_bound() {
        for bad in [f64::NAN, f64::INFINITY] {
            for bound in [
                Bound::Equal,
                Bound::Ulps(1e9),
                Bound::Absolute(1e9),
                Bound::Finite,
            ] {
                assert!(!case(bound, bad).holds(), "{bound:?} {bad}");
            }
        }
        for outcome in [Outcome::Nothing, Outcome::Refused, Outcome::Flag(true)] {
            assert!(!case(Bound::Absolute(1e9), outcome).holds());
        }
        let triple = Case::new("A", "", [1.0; 3], Bound::Ulps(9.0), [1.0, f64::NAN, 1.0]);
        assert!(!triple.holds());
    }

    #[test]
    fn the_protocol_must_fail_where_the_row_says_so() {
        let right = case(Bound::Equal, 1.0);
        assert!(right.clone().protocol(Protocol::Fails, 2.0).holds());
        assert!(!right.clone().protocol(Protocol::Fails, 1.0).holds());
        assert!(right.clone().protocol(Protocol::Holds, 1.0).holds());
        assert!(!right.protocol(Protocol::Holds, 2.0).holds());
    }

    #[test]
    fn infinities_of_one_sign_are_equal() {
        let infinite = Case::new("A", "", f64::INFINITY, Bound::Equal, f64::INFINITY);
        assert!(infinite.holds());
        assert!(infinite.to_string().contains("error 0"));
    }

    #[test]
    fn a_row_shows_its_error() {
        let case = case(Bound::Ulps(2.0), 1.0_f64.next_up()).protocol(Protocol::Fails, 1.5);
        assert_eq!(
            case.to_string(),
            "A01  ok      one\n     \
             exact     1   (bound: 2 ulp)\n     \
             protocol  1.5   error 5.0e-1, out of bound\n     \
             ours      1.0000000000000002   error 1 ulp"
        );
        assert_eq!(
            case.comparison(),
            "expected 1, got 1.0000000000000002, off by 1 ulp (bound: 2 ulp)"
        );
    }
}
