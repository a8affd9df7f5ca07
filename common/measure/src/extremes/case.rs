//! `Case`: a row of the table of extreme cases.

use std::fmt;

use super::bound::error;
use super::{Bound, Outcome};

/// The name of a row: a letter for the subject and a number.
pub type Id = &'static str;

/// A row of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// Its name.
    pub id: Id,
    /// The quantity that is computed, and its arguments.
    pub what: String,
    exact: Outcome,
    bound: Bound,
    condition: Option<f64>,
    protocol: Option<(Outcome, Protocol)>,
    ours: Outcome,
    certified: Option<Outcome>,
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
        id: Id,
        what: impl Into<String>,
        exact: impl Into<Outcome>,
        bound: Bound,
        ours: impl Into<Outcome>,
    ) -> Self {
        let exact = exact.into();
        let has_bound = !exact.numbers().is_empty();
        Self {
            id,
            what: what.into(),
            exact,
            // Nothing else has a distance.
            bound: if has_bound { bound } else { Bound::Equal },
            condition: None,
            protocol: None,
            ours: ours.into(),
            certified: None,
        }
    }

    /// A row of wrong results in number: ours, which must be none, and the protocol's.
    pub fn wrong<E>(id: Id, what: impl Into<String>, counts: Result<[usize; 2], E>) -> Self {
        let refused = [Outcome::Refused; 2];
        let both = counts.map_or(refused, |counts| counts.map(Outcome::from));
        case(id, what, both, 0.0, Bound::Equal, Protocol::Fails)
    }

    /// Adds the condition of the problem: by how many units in its last place the exact number
    /// changes, if each given number changes by one.
    pub fn condition(self, condition: Option<f64>) -> Self {
        Self { condition, ..self }
    }

    /// Adds the exact outcome by another arithmetic than the one of the row.
    pub fn certified(self, certified: Option<f64>) -> Self {
        let certified = certified.map(Outcome::from);
        Self { certified, ..self }
    }

    /// Adds the outcome of the protocol's formula.
    pub fn protocol(mut self, says: Protocol, outcome: impl Into<Outcome>) -> Self {
        self.protocol = Some((outcome.into(), says));
        self
    }

    /// Whether our outcome is within the bound, and the protocol's is or is not, as
    /// expected; and a certified outcome is the exact one.
    pub fn holds(&self) -> bool {
        let is_exact = |outcome| Bound::Ulps(1.0).admits(self.exact, outcome);
        let as_said = self.protocol.is_none_or(|(outcome, says)| {
            self.bound.admits(self.exact, outcome) == (says == Protocol::Holds)
        });
        as_said && self.bound.admits(self.exact, self.ours) && self.certified.is_none_or(is_exact)
    }
}

/// The computed outcomes of a row.
#[derive(Clone, Copy, Debug)]
pub struct Both {
    /// Our outcome and the protocol's.
    pub outcomes: [Outcome; 2],
    /// The condition of the problem, if it is known.
    pub condition: Option<f64>,
    /// The exact outcome by another arithmetic than the one of the row, unless it is left open.
    pub certified: Option<Outcome>,
}

impl From<[Outcome; 2]> for Both {
    fn from(outcomes: [Outcome; 2]) -> Self {
        Self {
            outcomes,
            condition: None,
            certified: None,
        }
    }
}

/// A row that compares our outcome and the outcome of the protocol's formula with an `exact`
/// one from elsewhere.
pub fn case(
    id: Id,
    what: impl Into<String>,
    both: impl Into<Both>,
    exact: impl Into<Outcome>,
    bound: Bound,
    says: Protocol,
) -> Case {
    let both = both.into();
    let [ours, theirs] = both.outcomes;
    Case {
        condition: both.condition,
        certified: both.certified,
        ..Case::new(id, what, exact, bound, ours).protocol(says, theirs)
    }
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (exact, ours, bound) = (self.exact, self.ours, self.bound);
        let verdict = if self.holds() { "ok" } else { "FAILED" };
        writeln!(f, "{}  {verdict:6}  {}", self.id, self.what)?;
        write!(f, "     exact     {exact}   (bound: {bound}")?;
        if let Some(condition) = self.condition.filter(|_| !exact.numbers().is_empty()) {
            write!(f, "; condition: {condition:.1e}")?;
        }
        writeln!(f, ")")?;
        if let Some((theirs, says)) = self.protocol {
            let says = match says {
                Protocol::Holds => "",
                Protocol::Fails => ", out of bound",
            };
            let error = error(exact, theirs);
            writeln!(f, "     protocol  {theirs}   error {error}{says}")?;
        }
        if let Some(certified) = self.certified {
            writeln!(f, "     certified {certified}")?;
        }
        write!(f, "     ours      {ours}   error {}", error(exact, ours))
    }
}

#[cfg(test)]
mod tests {
    use super::Protocol::{Fails, Holds};
    use super::*;

    fn holds(exact: impl Into<Outcome>, bound: Bound, ours: impl Into<Outcome>) -> bool {
        Case::new("A01", "one", exact, bound, ours).holds()
    }

    #[test]
    fn bounds_admit_outcomes_within_them() {
        let next = 1.0_f64.next_up();
        let [ulp, half] = [Bound::Ulps(1.0), Bound::Absolute(0.5)];
        assert!(holds(1.0, Bound::Equal, 1.0) && !holds(1.0, Bound::Equal, next));
        assert!(holds(1.0, ulp, next) && !holds(1.0, ulp, next.next_up()));
        assert!(holds(1.0, half, 1.5) && !holds(1.0, half, 1.6));
        assert!(holds(Outcome::Nothing, ulp, Outcome::Nothing));
        assert!(holds(f64::INFINITY, Bound::Equal, f64::INFINITY));
        let far = Bound::Absolute(1e9);
        for bound in [Bound::Equal, Bound::Ulps(1e9), far] {
            for bad in [f64::NAN, f64::INFINITY] {
                assert!(!holds(1.0, bound, bad), "{bound:?} {bad}");
                assert!(!holds([1.0; 3], bound, [1.0, bad, 1.0]), "{bound:?} {bad}");
            }
        }
        for outcome in [Outcome::Nothing, Outcome::Refused, Outcome::Flag(true)] {
            assert!(!holds(1.0, far, outcome));
        }
    }

    #[test]
    fn the_protocol_must_fail_where_the_row_says_so() {
        let case = Case::new("A01", "one", 1.0, Bound::Ulps(2.0), 1.0_f64.next_up());
        let holds = |says, theirs| case.clone().protocol(says, theirs).holds();
        assert!(holds(Fails, 2.0) && !holds(Fails, 1.0));
        assert!(holds(Holds, 1.0) && !holds(Holds, 2.0));
        let certified = |exact| case.clone().certified(Some(exact)).holds();
        assert!(certified(1.0) && !certified(1.1));
        let row = "A01  ok      one
     exact     1   (bound: 2 ulp)
     protocol  1.5   error 5.0e-1, out of bound
     ours      1.0000000000000002   error 1 ulp";
        assert_eq!(case.protocol(Fails, 1.5).to_string(), row);
    }
}
