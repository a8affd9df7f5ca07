//! Stiff and extreme cases: a table for the reader that is also a test.
//!
//! Each row computes one thing twice, by the protocol's formula and by ours,
//! and holds both against a value that neither has computed. The protocol's
//! must fail where the row says so: a comparison that it can't lose is none.

use std::fmt;

use crate::Error;

/// What a computation ends in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// A number, or a count.
    Number(f64),
    /// A point, a direction or a colour.
    Triple([f64; 3]),
    /// Yes or no: hit or not, lit or not.
    Flag(bool),
    /// Nothing: no hit, no direction.
    Nothing,
    /// The constructor refuses the arguments.
    Refused,
}

impl Outcome {
    /// The greatest distance between the numbers of two outcomes of a kind.
    fn distance(self, other: Self) -> Option<f64> {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) if a == b => Some(0.0),
            (Self::Number(a), Self::Number(b)) => Some((a - b).abs()),
            (Self::Triple(a), Self::Triple(b)) => {
                let apart = |i: usize| Self::Number(a[i]).distance(Self::Number(b[i]));
                // Unlike `max`, this keeps NaN.
                [apart(0)?, apart(1)?, apart(2)?]
                    .into_iter()
                    .reduce(|a, b| if a.is_nan() || a > b { a } else { b })
            }
            _ => None,
        }
    }

    /// The greatest magnitude of its numbers.
    fn magnitude(self) -> f64 {
        match self {
            Self::Number(number) => number.abs(),
            Self::Triple(numbers) => numbers.map(f64::abs).into_iter().fold(0.0, f64::max),
            _ => 0.0,
        }
    }
}

impl From<f64> for Outcome {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<[f64; 3]> for Outcome {
    fn from(numbers: [f64; 3]) -> Self {
        Self::Triple(numbers)
    }
}

impl From<bool> for Outcome {
    fn from(flag: bool) -> Self {
        Self::Flag(flag)
    }
}

impl From<usize> for Outcome {
    fn from(count: usize) -> Self {
        Self::Number(count as f64)
    }
}

impl<T: Into<Self>> From<Option<T>> for Outcome {
    fn from(outcome: Option<T>) -> Self {
        outcome.map_or(Self::Nothing, Into::into)
    }
}

impl<T: Into<Self>, E> From<Result<T, E>> for Outcome {
    fn from(outcome: Result<T, E>) -> Self {
        outcome.map_or(Self::Refused, Into::into)
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => f.write_str(&short(*number)),
            Self::Triple([x, y, z]) => write!(f, "({}, {}, {})", short(*x), short(*y), short(*z)),
            Self::Flag(true) => f.write_str("yes"),
            Self::Flag(false) => f.write_str("no"),
            Self::Nothing => f.write_str("none"),
            Self::Refused => f.write_str("refused"),
        }
    }
}

/// All digits of a number, with an exponent where it would be long without.
fn short(number: f64) -> String {
    if number == 0.0 || !number.is_finite() || (1e-5..1e16).contains(&number.abs()) {
        format!("{number}")
    } else {
        format!("{number:e}")
    }
}

/// What is close enough to the exact outcome.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// The same outcome.
    Equal,
    /// At most this many units in the last place of the exact number, or of
    /// the greatest of three.
    Ulps(f64),
    /// At most this far away.
    Absolute(f64),
    /// Any finite number, or nothing: where only NaN, infinity and a panic
    /// would be wrong.
    Finite,
}

impl Bound {
    fn admits(self, exact: Outcome, outcome: Outcome) -> bool {
        let distance = exact.distance(outcome);
        let equal = exact == outcome;
        match self {
            Self::Equal => equal,
            Self::Ulps(ulps) => {
                equal || distance.is_some_and(|d| d <= ulps * ulp(exact.magnitude()))
            }
            Self::Absolute(bound) => equal || distance.is_some_and(|d| d <= bound),
            Self::Finite => match outcome {
                Outcome::Number(number) => number.is_finite(),
                Outcome::Triple(numbers) => numbers.iter().all(|number| number.is_finite()),
                _ => true,
            },
        }
    }
}

impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Equal => f.write_str("equal"),
            Self::Ulps(ulps) => write!(f, "{ulps} ulp"),
            Self::Absolute(bound) => write!(f, "{bound:.1e}"),
            Self::Finite => f.write_str("finite"),
        }
    }
}

/// The distance between a number and the next greater one.
fn ulp(number: f64) -> f64 {
    number.abs().next_up() - number.abs()
}

/// How far an outcome is off, for a reader.
fn error(exact: Outcome, outcome: Outcome) -> String {
    match exact.distance(outcome) {
        Some(0.0) => "0".to_owned(),
        Some(distance) => {
            let ulps = distance / ulp(exact.magnitude());
            if ulps < 1e4 {
                format!("{ulps:.0} ulp")
            } else {
                format!("{distance:.1e}")
            }
        }
        None if exact == outcome => "0".to_owned(),
        None => "wrong".to_owned(),
    }
}

/// A row of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// A letter for the subject and a number.
    pub id: &'static str,
    /// What is computed, of which numbers.
    pub what: String,
    exact: Outcome,
    bound: Bound,
    protocol: Option<(Outcome, Protocol)>,
    ours: Outcome,
}

/// What a row says of the protocol's formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Protocol {
    /// It stays within the bound, too.
    Holds,
    /// It does not.
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

    /// The same row with the outcome of the protocol's formula.
    #[must_use]
    pub fn protocol(mut self, says: Protocol, outcome: impl Into<Outcome>) -> Self {
        self.protocol = Some((outcome.into(), says));
        self
    }

    /// Whether ours is within the bound, and the protocol's is where it should.
    #[must_use]
    pub fn holds(&self) -> bool {
        let as_said = self.protocol.is_none_or(|(outcome, says)| {
            self.bound.admits(self.exact, outcome) == (says == Protocol::Holds)
        });
        as_said && self.bound.admits(self.exact, self.ours)
    }

    /// What is expected of ours, what it is, and how far off, in one line.
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

/// The cases whose ids begin with one of the names; all without a name.
pub(crate) fn select(cases: Vec<Case>, names: &[String]) -> Result<Vec<Case>, Error> {
    let begins = |case: &Case, name: &String| {
        let (id, name) = (case.id.as_bytes(), name.as_bytes());
        id.len() >= name.len() && id[..name.len()].eq_ignore_ascii_case(name)
    };
    for name in names {
        if !cases.iter().any(|case| begins(case, name)) {
            let mut letters: Vec<_> = cases.iter().map(|case| &case.id[..1]).collect();
            letters.dedup();
            return Err(Error::Usage(format!(
                "there is no case \"{name}\"; the ids begin with {}",
                letters.join(", ")
            )));
        }
    }
    let wanted = |case: &Case| names.is_empty() || names.iter().any(|name| begins(case, name));
    Ok(cases.into_iter().filter(wanted).collect())
}

/// Checks a stage's table in a test: it has rows, each of them holds, and no id
/// comes twice.
///
/// # Panics
///
/// If that is not so; the message shows all rows that don't hold.
pub fn check(cases: &[Case]) {
    assert!(!cases.is_empty(), "there are no cases");
    let failed: Vec<_> = cases.iter().filter(|case| !case.holds()).collect();
    for case in &failed {
        eprintln!("{case}");
    }
    assert!(failed.is_empty(), "{} cases fail", failed.len());
    let mut ids: Vec<_> = cases.iter().map(|case| case.id).collect();
    ids.sort_unstable();
    let twice: Vec<_> = ids.windows(2).filter(|pair| pair[0] == pair[1]).collect();
    assert!(twice.is_empty(), "{twice:?}");
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case(bound: Bound, ours: impl Into<Outcome>) -> Case {
        Case::new("A01", "one", 1.0, bound, ours)
    }

    #[test]
    fn bounds_admit_what_lies_within() {
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
    fn what_is_no_number_is_within_no_bound() {
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
    fn the_protocol_must_fail_where_it_is_said_to() {
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
    fn a_row_shows_how_far_it_is_off() {
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

    #[test]
    fn names_select_by_the_beginning_of_the_id() {
        let all = || ["A01", "A02", "B01"].map(|id| Case::new(id, "", 1.0, Bound::Equal, 1.0));
        let ids = |names: &[&str]| {
            let names: Vec<_> = names.iter().map(|name| (*name).to_owned()).collect();
            let selected = select(all().to_vec(), &names);
            selected.map(|cases| cases.iter().map(|case| case.id).collect::<Vec<_>>())
        };
        assert_eq!(ids(&[]).unwrap(), ["A01", "A02", "B01"]);
        assert_eq!(ids(&["a"]).unwrap(), ["A01", "A02"]);
        assert_eq!(ids(&["B01", "A02"]).unwrap(), ["A02", "B01"]);
        let error = ids(&["X"]).unwrap_err().to_string();
        assert!(error.contains("begin with A, B"), "{error}");
    }

    #[test]
    #[should_panic(expected = "1 cases fail")]
    fn a_case_that_does_not_hold_fails() {
        check(&[case(Bound::Equal, 1.0), case(Bound::Equal, 2.0)]);
    }

    #[test]
    #[should_panic(expected = "A01")]
    fn an_id_that_comes_twice_fails() {
        check(&[case(Bound::Equal, 1.0), case(Bound::Equal, 1.0)]);
    }

    #[test]
    fn numbers_are_shown_with_all_digits_and_few_zeros() {
        let shown = [0.0, 1e-5, 9e-6, 0.1, 1e15, 1e16, -2.5, f64::INFINITY].map(short);
        let expected = [
            "0",
            "0.00001",
            "9e-6",
            "0.1",
            "1000000000000000",
            "1e16",
            "-2.5",
            "inf",
        ];
        assert_eq!(shown, expected);
        assert_eq!(short(f64::NAN), "NaN");
    }

    #[test]
    fn errors_are_shown_in_units_of_rounding_while_these_are_few() {
        let shown = |ours: f64| error(1.0.into(), ours.into());
        assert_eq!(shown(1.0), "0");
        assert_eq!(shown(1.0 + 3.0 * f64::EPSILON), "3 ulp");
        assert_eq!(shown(1.0 + 9999.0 * f64::EPSILON), "9999 ulp");
        assert_eq!(shown(1.0 + 10_000.0 * f64::EPSILON), "2.2e-12");
        assert_eq!(error(Outcome::Nothing, Outcome::Nothing), "0");
        assert_eq!(error(Outcome::Nothing, Outcome::Refused), "wrong");
        let triple = |x: f64| Outcome::Triple([0.5, x, -4.0]);
        assert_eq!(
            error(triple(1.0), triple(1.0 + 8.0 * f64::EPSILON)),
            "2 ulp"
        );
        let finite = |x| Case::new("A", "", [0.0; 3], Bound::Finite, [1.0, x, 1.0]).holds();
        assert!(finite(2.0) && !finite(f64::NAN));
    }

    #[test]
    #[should_panic(expected = "no cases")]
    fn a_table_without_a_row_fails() {
        check(&[]);
    }

    #[test]
    fn a_name_may_be_longer_than_an_id() {
        let cases = vec![Case::new("A01", "", 1.0, Bound::Equal, 1.0)];
        assert!(select(cases, &["A01B".to_owned()]).is_err());
    }
}
