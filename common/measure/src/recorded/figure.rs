//! Figures of points, as pages print them, and the names of these points.

use common::text;

use super::Row;

/// The name of one or two methods, such as `a04.sphere-far.stable-ours/protocol@512`.
pub struct Name<'n> {
    pub experiment: &'n str,
    pub methods: &'n str,
    /// A value of the parameter.
    pub at: Option<f64>,
}

impl<'n> Name<'n> {
    pub fn parse(name: &'n str) -> Option<Self> {
        let (name, at) = match name.split_once('@') {
            Some((name, at)) => (name, Some(at.parse().ok()?)),
            None => (name, None),
        };
        let (experiment, methods) = name.rsplit_once('.')?;
        Some(Self {
            experiment,
            methods,
            at,
        })
    }
}

/// The time of a point over that of another, with two digits.
pub fn time(own: &Row, other: &Row) -> String {
    text::rounded(own.seconds / other.seconds, 2)
}

/// An error, in percent if it is a fraction of decisions.
pub fn error(point: &Row) -> String {
    if point.unit == "all = 1" {
        format!("{} %", in_a_formula(100.0 * point.error))
    } else {
        in_a_formula(point.error)
    }
}

/// A slope with two decimals.
pub fn slope(point: &Row) -> String {
    match point.slope {
        // Not "-0.00".
        Some(slope) => format!("{:.2}", libm::round(slope * 1e2) / 1e2 + 0.0).replace('-', "−"),
        None => "no power law".to_owned(),
    }
}

/// A number with two digits, in the notation of the book's formulas.
fn in_a_formula(number: f64) -> String {
    let rounded = text::rounded(number, 2);
    match rounded.split_once('e') {
        Some((mantissa, power)) => format!(r"${mantissa} \cdot 10^{{{power}}}$"),
        None => rounded,
    }
}
