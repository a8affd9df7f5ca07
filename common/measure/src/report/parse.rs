//! Reads the measurements of an experiment from the file that they were written to.

use std::fmt;

use common::Median;

use crate::experiment::{Axis, Curve, Curves, Errors, Experiment, Interval, Problem, Slope, Unit};
use crate::point::{Point, Times};
use crate::provenance::Provenance;
use crate::report::Measured;

/// A text is no file of measurements.
#[derive(Debug, PartialEq, Eq)]
pub struct NotRecorded {
    /// The number of the line, from 1.
    line: usize,
    /// What is wrong with it.
    why: String,
}

impl fmt::Display for NotRecorded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.why)
    }
}

/// The theory of a method: `slope -0.5 from 16 to 4096: random`.
struct Theory<'a> {
    method: &'a str,
    slope: Slope,
}

impl<'a> Measured<'a> {
    /// The measurements in a text that [`csv`](Self::csv) has written.
    pub fn parse(text: &'a str) -> Result<Self, NotRecorded> {
        let mut measured = Self {
            experiment: Experiment::new(""),
            curves: Vec::new(),
            provenance: Provenance {
                machine: String::new(),
                version: String::new(),
                date: String::new(),
                rounds: 0,
            },
        };
        let mut theories: Vec<Theory> = Vec::new();
        let mut has_names = false;
        for (index, line) in text.lines().enumerate() {
            let wrong = |why: &str| NotRecorded {
                line: index + 1,
                why: why.to_owned(),
            };
            if let Some(comment) = line.strip_prefix("# ") {
                let (key, words) = comment
                    .split_once(':')
                    .ok_or_else(|| wrong("a comment needs a key and a colon"))?;
                let words = words.trim();
                if key == "theory" {
                    theories.push(theory(words).ok_or_else(|| wrong("no slope of a theory"))?);
                } else {
                    measured.take(key, words).map_err(|why| wrong(&why))?;
                }
            } else if has_names {
                let row = Row::of(line);
                let point = row.point().ok_or_else(|| wrong("no row of measurements"))?;
                let method = row.fields[0];
                match measured
                    .curves
                    .iter_mut()
                    .find(|curve| curve.method == method)
                {
                    Some(curve) => curve.points.push(point),
                    None => measured.curves.push(Curve::new(method, [point])),
                }
            } else {
                has_names = true;
            }
        }
        for theory in theories {
            for curve in &mut measured.curves {
                if curve.method == theory.method {
                    curve.slope = Some(theory.slope.clone());
                }
            }
        }
        if measured.curves.is_empty() {
            return Err(NotRecorded {
                line: text.lines().count(),
                why: "there are no measurements".to_owned(),
            });
        }
        Ok(measured)
    }

    /// A line of the head.
    fn take(&mut self, key: &str, words: &'a str) -> Result<(), String> {
        let (e, from) = (&mut self.experiment, &mut self.provenance);
        match key {
            "experiment" => e.name = words,
            "question" => e.question = words,
            "parameter" => e.parameter = words,
            "work" => e.work = words,
            "error" => e.error = words,
            "unit" => e.unit = unit(words),
            "exact" => e.exact = words,
            "against" if words == "work" => e.against = Axis::Work,
            "against" => e.against = Axis::Parameter,
            "curves" if words == "methods" => e.curves_are = Curves::Methods,
            "curves" => e.curves_are = Curves::Problems,
            "opposite" => e.opposite = (!words.is_empty()).then_some(words),
            "seeds" | "seconds" => {}
            "rounds" => from.rounds = words.parse().map_err(|_| "no number of rounds")?,
            "machine" => words.clone_into(&mut from.machine),
            "version" => words.clone_into(&mut from.version),
            "date" => words.clone_into(&mut from.date),
            _ => return Err(format!("there is no key {key}")),
        }
        Ok(())
    }
}

fn unit(words: &str) -> Unit<'_> {
    match words {
        "white = 1" => Unit::Light,
        "all = 1" => Unit::Fraction,
        other => match other.strip_prefix("fraction of ") {
            Some(value) => Unit::FractionOf(value),
            None => Unit::Other(other),
        },
    }
}

fn theory(words: &str) -> Option<Theory<'_>> {
    let (numbers, method) = words.strip_prefix("slope ")?.split_once(": ")?;
    let (value, ends) = numbers.split_once(" from ")?;
    let (low, high) = ends.split_once(" to ")?;
    Some(Theory {
        method,
        slope: Slope {
            value: value.parse().ok()?,
            between: low.parse().ok()?..=high.parse().ok()?,
        },
    })
}

/// The fields of a line.
struct Row<'a> {
    fields: Vec<&'a str>,
}

impl<'a> Row<'a> {
    fn of(line: &'a str) -> Self {
        // Only the name of the method may be in quotes.
        let (method, numbers) = match line.strip_prefix('"').and_then(|rest| rest.split_once('"')) {
            Some((method, numbers)) => (method, numbers.trim_start_matches(',')),
            None => line.split_once(',').unwrap_or((line, "")),
        };
        let mut fields = vec![method];
        fields.extend(numbers.split(','));
        Self { fields }
    }

    /// A number; none of an empty field.
    fn number(&self, column: usize) -> Option<f64> {
        self.fields.get(column)?.parse().ok()
    }

    /// Three numbers from a column on: the median, and the ends of its interval.
    fn median(&self, column: usize) -> Option<Median> {
        Some(Median {
            value: self.number(column)?,
            low: self.number(column + 1)?,
            high: self.number(column + 2)?,
        })
    }

    fn problem(&self) -> Option<Problem> {
        Some(Problem {
            condition: self.number(8)?,
            error: self.number(9)?,
            error_over_condition: self.number(10)?,
        })
    }

    fn point(&self) -> Option<Point<'static>> {
        let interval = Interval {
            low: self.number(4)?,
            high: self.number(5)?,
        };
        Some(Point {
            parameter: self.number(1)?,
            work: self.number(2)?,
            errors: Errors {
                rms: self.number(3)?,
                interval,
                p99: self.number(6),
                max: self.number(7),
                problem: self.problem(),
            },
            times: Times::recorded(self.median(11)?, self.median(14)),
        })
    }
}
