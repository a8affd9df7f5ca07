//! The recording of the book: one measurement of all experiments, from which its pages take their figures.
//!
//! A page names a figure by an anchor instead of typing it:
//!
//! | anchor | becomes |
//! |---|---|
//! | `{{recorded time a04.sphere-far.compensated/stable-ours}}` | the quotient of the times of two methods, `1.42 ± 0.02`, or `no difference` |
//! | `{{recorded times a04.sphere-far.stable-ours/protocol}}` | the same behind "takes": `1.42 ± 0.02 times as long` |
//! | `{{recorded error a04.sphere-far.stable-ours@512}}` | the root mean square error, or the fraction of wrong answers |
//! | `{{recorded slope a04.sphere-far.stable-ours}}` | the slope of the curve, or `no power law` |
//! | `{{recorded where}}` | machine, build, commit and date |
//! | `{{recorded elsewhere}}` | the same of the recording that it is compared with |
//!
//! Behind `±` stands half of the interval of 95 %. One of the two methods of a quotient is the first one of its
//! experiment, with which the others took turns. Where another recording has another sign, both are printed.
//!
//! Methods are named in lower case with dashes. `@` names the value of the parameter, by default the last one
//! that both methods have.

mod anchor;
mod compare;
mod figure;
mod recorded_point;
#[cfg(test)]
mod tests;

pub use anchor::Anchor;
pub use compare::{Comparison, Turned};
use figure::Name;
pub use recorded_point::{Measurement, RecordedPoint};

/// A recording.
#[derive(Debug, Default)]
pub struct Recording<'t> {
    /// The lines of its head: keys and words.
    head: Vec<(&'t str, &'t str)>,
    /// The names of the columns.
    columns: &'t str,
    rows: Vec<RecordedPoint<'t>>,
    /// Points of another recording, whose quotients have another sign.
    elsewhere: Option<Box<Self>>,
}

impl<'t> Recording<'t> {
    /// Reads a file that [`csv`](crate::report::csv) has written.
    pub fn parse(text: &'t str) -> Result<Self, String> {
        let mut recording = Self::default();
        let mut lines = text.lines();
        // After the head stand the names of the columns.
        for line in lines.by_ref() {
            let Some(line) = line.strip_prefix("# ") else {
                recording.columns = line;
                break;
            };
            recording.head.extend(line.split_once(": "));
        }
        for line in lines {
            let row =
                RecordedPoint::parse(line).ok_or_else(|| format!("this is no row: {line}"))?;
            recording.rows.push(row);
        }
        Ok(recording)
    }

    /// With the points of another recording whose quotients have another sign, the `elsewhere` of a
    /// [`Comparison`].
    pub fn with_elsewhere(mut self, text: &'t str) -> Result<Self, String> {
        self.elsewhere = Some(Box::new(Self::parse(text)?));
        Ok(self)
    }

    /// The points of an experiment.
    pub fn experiment(&self, name: &str) -> impl Iterator<Item = &RecordedPoint<'t>> {
        self.rows.iter().filter(move |row| row.experiment == name)
    }

    /// A page with figures instead of anchors. A figure that is not recorded is an error.
    pub fn fill(&self, page: &str) -> Result<String, String> {
        let mut filled = String::new();
        let mut rest = page;
        while let Some(anchor) = Anchor::first(rest) {
            filled += &rest[..anchor.start];
            filled += &self.figure(anchor.words)?;
            rest = &rest[anchor.end..];
        }
        Ok(filled + rest)
    }

    /// The figure of an anchor.
    pub fn figure(&self, anchor: &str) -> Result<String, String> {
        let figure = match anchor.split_once(' ') {
            None if anchor == "where" => Some(self.place()),
            None if anchor == "elsewhere" => self.elsewhere.as_deref().map(Self::place),
            None => None,
            Some((quantity, name)) => self.quantity(quantity, name),
        };
        figure.ok_or_else(|| format!("{{{{recorded {anchor}}}}} is not recorded"))
    }

    /// Machine, build, commit and date.
    fn place(&self) -> String {
        let mut words = Vec::new();
        for wanted in ["machine", "version", "compiler", "commit", "date"] {
            let found = self.head.iter().find(|(key, _)| *key == wanted);
            words.extend(found.map(|(_, words)| *words));
        }
        words.join("; ")
    }

    fn quantity(&self, quantity: &str, name: &str) -> Option<String> {
        let name = Name::parse(name)?;
        if let "time" | "times" = quantity {
            let (here, elsewhere) = self.time(&name)?;
            return Some(match elsewhere {
                _ if quantity == "times" => figure::times_as_long(here, elsewhere),
                Some(there) => [here, there].map(figure::quotient).join("; elsewhere "),
                None => figure::quotient(here),
            });
        }
        let point = self.points(&name, name.methods).pop()?;
        match quantity {
            "error" => Some(figure::error(point)),
            "slope" => Some(figure::slope(point)),
            _ => None,
        }
    }

    /// The quotient of the times of two methods, at the last value of the parameter that both have; and
    /// the quotient elsewhere, if it has another sign.
    fn time(&self, name: &Name) -> Option<(Measurement, Option<Measurement>)> {
        let (own, other) = name.methods.split_once('/')?;
        let others = self.points(name, other);
        for own in self.points(name, own).into_iter().rev() {
            for other in &others {
                if other.parameter == own.parameter {
                    let elsewhere = self.elsewhere.as_ref();
                    let elsewhere = elsewhere.and_then(|there| quotient(&there.rows, own, other));
                    return Some((quotient(&self.rows, own, other)?, elsewhere));
                }
            }
        }
        None
    }

    /// The points of a method; those at the value of the parameter, if the name has one.
    fn points(&self, name: &Name, method: &str) -> Vec<&RecordedPoint<'t>> {
        let mut points: Vec<_> = self.rows.iter().collect();
        points.retain(|row| row.experiment == name.experiment && row.has_method(method));
        if let Some(at) = name.at {
            points.retain(|row| row.parameter == at);
        }
        points
    }
}

/// The quotient of the times of two points in some rows. The times of all methods come from turns with
/// the first one: no other quotient has an interval.
fn quotient(
    rows: &[RecordedPoint],
    own: &RecordedPoint,
    other: &RecordedPoint,
) -> Option<Measurement> {
    if let Some(quotient) = over_first(rows, own).filter(|_| is_first(rows, other)) {
        return Some(quotient);
    }
    let inverse = over_first(rows, other).filter(|_| is_first(rows, own));
    inverse.map(Measurement::inverse)
}

/// Whether a point belongs to the first method of its experiment.
fn is_first(rows: &[RecordedPoint], point: &RecordedPoint) -> bool {
    let first = rows.iter().find(|row| row.experiment == point.experiment);
    first.is_some_and(|first| first.method == point.method)
}

/// The time of a point over that of the first method.
fn over_first(rows: &[RecordedPoint], point: &RecordedPoint) -> Option<Measurement> {
    let own = rows
        .iter()
        .find(|row| row.is_at(point) && row.method == point.method)?;
    let first = rows
        .iter()
        .find(|row| row.is_at(point) && is_first(rows, row))?;
    Some(own.seconds.over(first.seconds.value))
}
