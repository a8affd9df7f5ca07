//! `Case`: a row of the table of extreme cases.

use std::fmt;

use super::bound::error;
use super::{AgainstProtocol, Bound, Condition, Outcome};

/// A row of the table: one quantity, computed by our code and by the protocol's formula, and
/// compared with its exact value from elsewhere.
///
/// Build one as a literal over [`Case::of`], or over [`Case::default`] where the protocol has no
/// formula.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Case {
    /// Its name: a letter for the subject and a number.
    pub id: String,
    /// The quantity that is computed, and its arguments.
    pub what: String,
    /// The exact outcome, by a closed form or by arithmetic with more digits.
    pub exact: Outcome,
    /// How far an outcome may be from the exact one. Outcomes without numbers have no distance and
    /// have to be equal.
    pub bound: Bound,
    /// The outcome of our code, which has to be within the bound.
    pub ours: Outcome,
    /// The outcome of the protocol's formula, if it has one.
    pub theirs: Option<Outcome>,
    /// What the test expects of the protocol's outcome.
    pub protocol: Protocol,
    /// The condition of the problem, or why there is none. A decision and an exact value of 0 need no
    /// word.
    pub condition: Condition,
}

/// What is expected of the protocol's formula.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Protocol {
    /// Its error is within the bound, too.
    #[default]
    Holds,
    /// Its error is larger.
    Fails,
}

impl Case {
    /// The computed outcomes of a row, which still lacks its words and the exact outcome.
    pub fn of(ours: impl Into<Outcome>, theirs: impl Into<Outcome>) -> Self {
        Self {
            ours: ours.into(),
            theirs: Some(theirs.into()),
            ..Self::default()
        }
    }

    /// The outcomes of a row that counts wrong results.
    pub fn of_wrong<E>(counts: Result<AgainstProtocol<usize>, E>) -> Self {
        let outcomes =
            |counts: AgainstProtocol<usize>| [counts.ours, counts.theirs].map(Outcome::from);
        let [ours, theirs] = counts.map_or([Outcome::Refused; 2], outcomes);
        Self::of(ours, theirs)
    }

    /// The outcome of a row where the protocol has no formula.
    pub fn of_ours(ours: impl Into<Outcome>) -> Self {
        Self {
            ours: ours.into(),
            ..Self::default()
        }
    }

    /// Why the case has no condition.
    fn without_condition(&self) -> Option<&str> {
        let numbers = self.exact.numbers();
        match &self.condition {
            Condition::Without(reason) => Some(reason),
            _ if numbers.is_empty() => Some("a decision"),
            _ if numbers.iter().all(|x| *x == 0.0) => Some("the exact value is 0"),
            Condition::Known(_) | Condition::Unstated => None,
        }
    }

    /// Whether the case states its condition, or why there is none.
    pub(super) fn states_its_condition(&self) -> bool {
        matches!(self.condition, Condition::Known(_)) || self.without_condition().is_some()
    }

    /// Whether our outcome is within the bound, and the protocol's is or is not, as expected.
    pub fn holds(&self) -> bool {
        let is_right = self.bound.admits(self.exact, self.ours);
        let is_as_expected = self.theirs.is_none_or(|theirs| {
            let holds = self.bound.admits(self.exact, theirs);
            holds == (self.protocol == Protocol::Holds)
        });
        is_right && is_as_expected
    }
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (exact, ours) = (self.exact, self.ours);
        let verdict = if self.holds() { "ok" } else { "FAILED" };
        writeln!(f, "{}  {verdict:6}  {}", self.id, self.what)?;
        let has_numbers = !exact.numbers().is_empty();
        let bound = if has_numbers {
            self.bound
        } else {
            Bound::Equal
        };
        write!(f, "     exact     {exact}   (bound: {bound}")?;
        match (&self.condition, self.without_condition()) {
            (_, Some(reason)) => write!(f, "; no condition: {reason}")?,
            (Condition::Known(condition), None) => write!(f, "; condition: {condition:.1e}")?,
            (Condition::Without(_) | Condition::Unstated, None) => {}
        }
        writeln!(f, ")")?;
        if let Some(theirs) = self.theirs {
            let expected = match self.protocol {
                Protocol::Holds => "",
                Protocol::Fails => ", out of bound",
            };
            let error = error(exact, theirs);
            writeln!(f, "     protocol  {theirs}   error {error}{expected}")?;
        }
        write!(f, "     ours      {ours}   error {}", error(exact, ours))
    }
}

#[cfg(test)]
mod tests {
    use super::Outcome::{Nothing, Number, Refused};
    use super::Protocol::{Fails, Holds};
    use super::*;

    fn holds(exact: impl Into<Outcome>, bound: Bound, ours: impl Into<Outcome>) -> bool {
        let case = Case {
            exact: exact.into(),
            bound,
            ours: ours.into(),
            ..Case::default()
        };
        case.holds()
    }

    #[test]
    fn bounds_admit_outcomes_within_them() {
        let next = 1.0_f64.next_up();
        let [ulp, half] = [Bound::Ulps(1.0), Bound::Absolute(0.5)];
        assert!(holds(1.0, Bound::Equal, 1.0) && !holds(1.0, Bound::Equal, next));
        assert!(holds(1.0, ulp, next) && !holds(1.0, ulp, next.next_up()));
        assert!(holds(1.0, half, 1.5) && !holds(1.0, half, 1.6));
        assert!(holds(Nothing, ulp, Nothing));
        assert!(holds(f64::INFINITY, Bound::Equal, f64::INFINITY));
        let far = Bound::Absolute(1e9);
        for bound in [Bound::Equal, Bound::Ulps(1e9), far] {
            for bad in [f64::NAN, f64::INFINITY] {
                assert!(!holds(1.0, bound, bad), "{bound:?} {bad}");
                assert!(!holds([1.0; 3], bound, [1.0, bad, 1.0]), "{bound:?} {bad}");
            }
        }
        for outcome in [Nothing, Refused, Outcome::Flag(true)] {
            assert!(!holds(1.0, far, outcome));
        }
    }

    #[test]
    fn the_protocol_must_fail_where_the_row_says_so() {
        let case = Case {
            id: "A01".into(),
            what: "one".into(),
            exact: Number(1.0),
            bound: Bound::Ulps(2.0),
            ours: Number(1.0_f64.next_up()),
            ..Case::default()
        };
        let holds = |protocol, theirs| {
            let case = Case {
                theirs: Some(Number(theirs)),
                protocol,
                ..case.clone()
            };
            case.holds()
        };
        assert!(holds(Fails, 2.0) && !holds(Fails, 1.0));
        assert!(holds(Holds, 1.0) && !holds(Holds, 2.0));
        let row = "A01  ok      one
     exact     1   (bound: 2 ulp; condition: 3.0e0)
     protocol  1.5   error 5.0e-1, out of bound
     ours      1.0000000000000002   error 1 ulp";
        let case = Case {
            theirs: Some(Number(1.5)),
            protocol: Fails,
            condition: Condition::Known(3.0),
            ..case
        };
        assert_eq!(case.to_string(), row);
    }

    #[test]
    fn a_case_says_why_it_has_no_condition() {
        let case = |exact, condition| Case {
            exact,
            condition,
            ours: exact,
            ..Case::default()
        };
        let says = |exact, condition| {
            let shown = case(exact, condition).to_string();
            let first = shown.lines().nth(1).unwrap_or_default().to_owned();
            first.split_once("; ").map(|(_, words)| words.to_owned())
        };
        let decision = says(Nothing, Condition::Unstated);
        assert_eq!(decision.as_deref(), Some("no condition: a decision)"));
        let zero = says(Number(0.0), Condition::Unstated);
        assert_eq!(zero.as_deref(), Some("no condition: the exact value is 0)"));
        let count = says(Number(3.0), Condition::Without("a count".into()));
        assert_eq!(count.as_deref(), Some("no condition: a count)"));
        assert_eq!(says(Number(3.0), Condition::Unstated), None);
        assert!(!case(Number(3.0), Condition::Unstated).states_its_condition());
        assert!(case(Number(3.0), Condition::Known(1.0)).states_its_condition());
    }
}
