//! The front: the methods that no other beats in error and time.
//!
//! Error and time have intervals, and unless the intervals of two methods are apart by a factor, there is
//! a tie. Of two methods with equal times the more exact one beats the other,
//! and of two with equal errors the faster one.

use common::Median;

use crate::experiment::{Axis, Curve, Curves, Interval, Point, Unit};
use crate::report::{Measured, compact};

/// The factor between two times up to which they count as equal: they differ by as much between
/// builds, and beside other work.
pub(crate) const EQUAL_TIMES: f64 = 1.2;

/// The factor between two errors up to which they count as equal: half a digit of a binary number.
const EQUAL_ERRORS: f64 = std::f64::consts::SQRT_2;

/// The error of a fraction, or of a decision, that is wrong in every case.
const ALL_WRONG: f64 = 1.0;

/// A point of a curve, to be compared with those of other methods.
#[derive(Clone, Copy)]
pub(crate) struct Contender {
    /// The number of its curve.
    pub curve: usize,
    pub parameter: f64,
    pub error: f64,
    pub interval: Interval,
    pub time: Median,
}

impl Contender {
    fn is_faster(&self, other: &Self) -> bool {
        EQUAL_TIMES * self.time.high < other.time.low
    }

    fn is_more_exact(&self, other: &Self) -> bool {
        self.interval.high < other.interval.low && EQUAL_ERRORS * self.error < other.error
    }

    /// Whether it is better in time or in error, and not worse in the other one.
    fn beats(&self, other: &Self) -> bool {
        self.is_faster(other) && !other.is_more_exact(self)
            || self.is_more_exact(other) && !other.is_faster(self)
    }
}

/// The methods of a front, for the problems with some value of the parameter.
pub(crate) struct Front {
    /// The parameter, where it changes the problem.
    pub parameter: Option<f64>,
    /// All methods, the most exact last.
    pub contenders: Vec<Contender>,
    /// The contenders that no other beats, from fast to slow.
    pub unbeaten: Vec<Contender>,
}

impl Front {
    /// Whether no method beats this point of a curve.
    pub(crate) fn holds(&self, curve: usize, point: &Point) -> bool {
        let is_point = |one: &Contender| one.curve == curve && one.parameter == point.parameter;
        self.unbeaten.iter().any(is_point)
    }

    fn of(parameter: Option<f64>, contenders: Vec<Contender>, unit: Unit) -> Self {
        let is_useless = |one: &Contender| {
            let has_limit = matches!(unit, Unit::Fraction | Unit::FractionOf(_));
            !one.error.is_finite() || has_limit && one.error >= ALL_WRONG
        };
        let mut unbeaten = contenders.clone();
        unbeaten.retain(|one| !is_useless(one));
        unbeaten.retain(|one| {
            !contenders
                .iter()
                .any(|other| !is_useless(other) && other.beats(one))
        });
        unbeaten.sort_by(|a, b| a.time.value.total_cmp(&b.time.value));
        Self {
            parameter,
            contenders,
            unbeaten,
        }
    }
}

impl<'a> Measured<'a> {
    /// The fronts: one of all points for errors against work; else one for each problem. A
    /// rule for decisions must be right for all problems, so that its greatest fraction of errors counts,
    /// and there is one front, too. None of an experiment of problems.
    ///
    /// `opposite` is the experiment with the opposite mistake, if there is one: the
    /// greater fraction of both counts.
    pub(crate) fn fronts(&self, opposite: Option<&Self>) -> Vec<Front> {
        let e = &self.experiment;
        if e.curves_are == Curves::Problems {
            return Vec::new();
        }
        if e.unit == Unit::Fraction {
            let mut contenders = Vec::new();
            for (c, curve) in self.curves.iter().enumerate() {
                contenders.extend(as_a_rule(c, curve, opposite));
            }
            return vec![Front::of(None, contenders, e.unit)];
        }
        let mut all = Vec::new();
        for (c, curve) in self.curves.iter().enumerate() {
            all.extend(curve.points.iter().map(|point| contender(c, point)));
        }
        if e.against == Axis::Work {
            return vec![Front::of(None, all, e.unit)];
        }
        let mut fronts = Vec::new();
        for parameter in self.parameters() {
            let mut of_problem = all.clone();
            of_problem.retain(|one| one.parameter == parameter);
            fronts.push(Front::of(Some(parameter), of_problem, e.unit));
        }
        fronts
    }

    /// The curve of a method.
    pub(crate) fn curve(&self, method: &str) -> Option<&Curve<'a>> {
        self.curves.iter().find(|curve| curve.method == method)
    }

    /// All values of the parameter, from small to large.
    pub(crate) fn parameters(&self) -> Vec<f64> {
        let mut all = Vec::new();
        for curve in &self.curves {
            all.extend(curve.points.iter().map(|point| point.parameter));
        }
        all.sort_by(f64::total_cmp);
        all.dedup();
        all
    }

    /// The methods that no other beats, with the errors or problems for which that is so: a sentence
    /// without times, which differ between machines. Empty for an experiment of problems.
    pub(crate) fn unbeaten(&self, opposite: Option<&Self>) -> String {
        let fronts = self.fronts(opposite);
        let mut methods = Vec::new();
        for (c, curve) in self.curves.iter().enumerate() {
            let is_own = |one: &&Contender| one.curve == c;
            let words = match &fronts[..] {
                [] => None,
                [
                    Front {
                        parameter: None,
                        unbeaten,
                        ..
                    },
                ] => {
                    let own: Vec<_> = unbeaten.iter().filter(is_own).collect();
                    errors_in_words(self.experiment.unit, &own)
                }
                fronts => {
                    let on: Vec<_> = fronts
                        .iter()
                        .map(|front| front.unbeaten.iter().any(|one| is_own(&one)))
                        .collect();
                    let parameters: Vec<_> = fronts.iter().filter_map(|f| f.parameter).collect();
                    ranges_in_words(&parameters, &on)
                }
            };
            if let Some(words) = words {
                methods.push(format!("{} ({words})", curve.method));
            }
        }
        methods.join(", ")
    }

    /// A row of a Markdown table, unless it compares problems: experiment, question, and front.
    pub fn row(&self, opposite: Option<&Self>) -> Option<String> {
        let e = &self.experiment;
        if e.curves_are == Curves::Problems {
            return None;
        }
        let unbeaten = self.unbeaten(opposite);
        Some(format!("| `{}` | {} | {unbeaten} |", e.name, e.question))
    }
}

/// A curve of decisions as one contender: its greatest fraction of wrong ones, and its time at
/// the last value of the parameter.
fn as_a_rule(c: usize, curve: &Curve, opposite: Option<&Measured>) -> Option<Contender> {
    let mut rule = contender(c, curve.points.last()?);
    let also = opposite.and_then(|other| other.curve(curve.method));
    let also = also.iter().flat_map(|other| &other.points);
    for point in curve.points.iter().chain(also) {
        if point.errors.rms > rule.error {
            rule.error = point.errors.rms;
            rule.interval = point.errors.interval;
        }
    }
    Some(rule)
}

fn contender(c: usize, point: &Point) -> Contender {
    Contender {
        curve: c,
        parameter: point.parameter,
        error: point.errors.rms,
        interval: point.errors.interval,
        time: point.times.compared(),
    }
}

/// The errors of a method on the front.
fn errors_in_words(unit: Unit, own: &[&Contender]) -> Option<String> {
    let words = |one: &Contender| match unit {
        _ if one.error == 0.0 => "no error".to_owned(),
        Unit::Fraction => format!("{} % wrong", compact(libm::round(1e3 * one.error) / 10.0)),
        _ => two_digits(one.error),
    };
    match own {
        [] => None,
        [only] => Some(words(only)),
        [fastest, .., slowest] => Some(format!("{} to {}", words(fastest), words(slowest))),
    }
}

/// A number with two digits, and with an exponent where it would have many zeros.
fn two_digits(number: f64) -> String {
    let text = format!("{number:.1e}");
    match text.parse::<f64>() {
        Ok(rounded) if (1e-3..1e3).contains(&rounded) => rounded.to_string(),
        _ => text,
    }
}

/// The values of the parameter at which a method is on the front.
fn ranges_in_words(parameters: &[f64], is_on: &[bool]) -> Option<String> {
    if is_on.iter().all(|on| *on) {
        return Some("everywhere".to_owned());
    }
    let mut ranges = Vec::new();
    let mut start = None;
    for (n, on) in is_on.iter().chain([&false]).enumerate() {
        match (start, on) {
            (None, true) => start = Some(n),
            (Some(from), false) => {
                let (low, high) = (
                    compact_power(parameters[from]),
                    compact_power(parameters[n - 1]),
                );
                ranges.push(match from {
                    _ if from + 1 == n => format!("at {low}"),
                    0 => format!("up to {high}"),
                    _ if n == parameters.len() => format!("from {low}"),
                    _ => format!("from {low} to {high}"),
                });
                start = None;
            }
            _ => {}
        }
    }
    (!ranges.is_empty()).then(|| ranges.join(" and "))
}

/// A parameter in few characters: five digits at most.
pub(crate) fn compact_power(number: f64) -> String {
    if (1e-3..1e5).contains(&number) {
        compact(number)
    } else {
        format!("{number:.1e}").replace(".0e", "e")
    }
}
