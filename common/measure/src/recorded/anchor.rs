//! `Anchor`: the name of a figure in a page, and the figure.

use std::fmt::Write;

use common::Median;

use super::words::{self, Relation};
use super::{Recordings, StageRecordings};
use crate::experiment::{Axis, Curve, HALF_GREY_LEVEL, Point, Unit};
use crate::front::compact_power;
use crate::report::{Measured, opposite_of};

/// An anchor in a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Anchor<'t> {
    /// Its first byte.
    pub start: usize,
    /// The byte behind it.
    pub end: usize,
    /// The words that name the figure.
    pub words: &'t str,
}

const OPEN: &str = "{{recorded ";
const CLOSE: &str = "}}";

impl<'t> Anchor<'t> {
    /// The first anchor in a text.
    pub fn first(text: &'t str) -> Option<Self> {
        let start = text.find(OPEN)?;
        let words = start + OPEN.len();
        let end = words + text[words..].find(CLOSE)?;
        Some(Self {
            start,
            end: end + CLOSE.len(),
            words: text[words..end].trim(),
        })
    }
}

/// `a04.sphere-far.stable/protocol@512`
struct Name<'n> {
    stage: &'n str,
    experiment: &'n str,
    methods: Vec<&'n str>,
    parameter: Option<&'n str>,
}

impl<'n> Name<'n> {
    fn of(name: &'n str) -> Result<Self, String> {
        let (name, parameter) = match name.split_once('@') {
            Some((name, parameter)) => (name, Some(parameter)),
            None => (name, None),
        };
        let mut parts = name.splitn(3, '.');
        let stage = parts.next().unwrap_or_default();
        let experiment = parts.next().ok_or("a name is STAGE.EXPERIMENT.METHOD")?;
        let methods = parts.next().map(|methods| methods.split('/').collect());
        Ok(Self {
            stage,
            experiment,
            methods: methods.unwrap_or_default(),
            parameter,
        })
    }
}

/// An experiment of a stage.
struct Found<'r, 'a> {
    stage: &'r StageRecordings<'a>,
    measured: &'r Measured<'a>,
}

impl Recordings<'_> {
    /// The figure of an anchor, in words.
    pub fn figure(&self, anchor: &str) -> Result<String, String> {
        let words: Vec<_> = anchor.split_whitespace().collect();
        match words[..] {
            ["fronts"] => Ok(self.fronts()),
            ["where"] => self.place(),
            ["time", name] => self.time(name, None),
            ["time", name, relation] => self.time(name, Some(relation)),
            [quantity, name] => {
                let name = Name::of(name)?;
                let found = found(self.stages(), &name)?;
                found.figure(quantity, &name)
            }
            _ => Err(format!("there is no figure \"{anchor}\"")),
        }
    }

    fn place(&self) -> Result<String, String> {
        let stages = self.stages();
        let mut all = stages.iter().flat_map(|stage| &stage.experiments);
        let first = all.next().ok_or("there are no recordings")?;
        let latest = all
            .map(|one| &one.provenance)
            .fold(&first.provenance, |latest, one| {
                if one.date > latest.date { one } else { latest }
            });
        let (machine, version, date) = (&latest.machine, &latest.version, &latest.date);
        Ok(format!("{machine}; {version}; {date}"))
    }

    /// The quotient of the times of two methods. What the sentence says about it must be so in all
    /// builds.
    fn time(&self, name: &str, relation: Option<&str>) -> Result<String, String> {
        let parsed = Name::of(name)?;
        let relation = match relation {
            Some(word) => Some(Relation::named(word).ok_or("it is longer, shorter or same")?),
            None => None,
        };
        let mut shown = None;
        for build in &self.builds {
            let quotient = found(&build.stages, &parsed)?.quotient_of_times(&parsed)?;
            let measured = Relation::of(&quotient.value);
            if let Some(relation) = relation
                && relation != measured
            {
                let (build, said) = (build.name, relation.name());
                let (low, high) = (quotient.value.low, quotient.value.high);
                return Err(format!(
                    "{name} is said to be {said}, and is {} in the build {build}: {low:.2} to {high:.2}",
                    measured.name()
                ));
            }
            shown.get_or_insert(quotient);
        }
        let shown = shown.ok_or("there are no recordings")?;
        let words = words::as_long(&shown.value);
        Ok(match parsed.parameter {
            Some("most") if Relation::of(&shown.value) == Relation::Longer => {
                format!("up to {}", words.replace("about ", ""))
            }
            _ => words,
        })
    }
}

fn found<'r, 'a>(stages: &'r [StageRecordings<'a>], name: &Name) -> Result<Found<'r, 'a>, String> {
    let stage = stages.iter().find(|stage| stage.short() == name.stage);
    let stage = stage.ok_or_else(|| format!("there is no stage {}", name.stage))?;
    let is_named = |one: &&Measured| one.experiment.name == name.experiment;
    if let Some(measured) = stage.experiments.iter().find(is_named) {
        return Ok(Found { stage, measured });
    }
    let known = stage.experiments.iter().map(|one| one.experiment.name);
    let known = known.collect::<Vec<_>>().join(", ");
    Err(format!(
        "there is no experiment {}; there are {known}",
        name.experiment
    ))
}

/// A quotient, at a value of the parameter.
struct Quotient {
    value: Median,
}

impl<'r, 'a> Found<'r, 'a> {
    /// A curve by its name in lower case with dashes, or the beginning of it that no other has.
    fn curve(&self, name: &str) -> Result<&'r Curve<'a>, String> {
        let curves = &self.measured.curves;
        if let Some(curve) = curves.iter().find(|curve| dashed(curve.method) == name) {
            return Ok(curve);
        }
        let begins = |curve: &&Curve| dashed(curve.method).starts_with(name);
        let found: Vec<_> = curves.iter().filter(begins).collect();
        if let [curve] = found[..] {
            return Ok(curve);
        }
        let known: Vec<_> = curves.iter().map(|curve| dashed(curve.method)).collect();
        Err(format!(
            "there is no method {name}; there are {}",
            known.join(", ")
        ))
    }

    /// The pairs of points of two methods at the same values of the parameter.
    fn pairs(&self, name: &Name) -> Result<Vec<[&'r Point<'a>; 2]>, String> {
        let [own, other] = name.methods[..] else {
            return Err("it needs two methods, with a / between them".to_owned());
        };
        let (own, other) = (self.curve(own)?, self.curve(other)?);
        let mut pairs = Vec::new();
        for point in &own.points {
            let same = |of_other: &&Point| of_other.parameter == point.parameter;
            if let Some(of_other) = other.points.iter().find(same)
                && name
                    .parameter
                    .is_none_or(|at| at == "most" || is_at(point, at))
            {
                pairs.push([point, of_other]);
            }
        }
        if pairs.is_empty() {
            return Err("the methods have no such value of the parameter in common".to_owned());
        }
        Ok(pairs)
    }

    fn quotient_of_times(&self, name: &Name) -> Result<Quotient, String> {
        let mut quotients = Vec::new();
        for [own, other] in self.pairs(name)? {
            let (own, other) = (own.times.compared(), other.times.compared());
            quotients.push(Quotient {
                value: Median {
                    low: own.low / other.high,
                    value: own.value / other.value,
                    high: own.high / other.low,
                },
            });
        }
        if name.parameter == Some("most") {
            quotients.sort_by(|a, b| a.value.value.total_cmp(&b.value.value));
        }
        quotients
            .pop()
            .ok_or_else(|| "there is no quotient".to_owned())
    }

    fn figure(&self, quantity: &str, name: &Name) -> Result<String, String> {
        let e = &self.measured.experiment;
        let opposite = opposite_of(self.measured, &self.stage.experiments);
        match quantity {
            "front" => Ok(self.measured.unbeaten(opposite)),
            "errors" => Ok(self.table_of_errors()),
            "error" => {
                let point = self.point(name)?;
                Ok(self.error_in_words(point))
            }
            "times" => {
                let quotient = self.quotient_of_times(name)?;
                Ok(words::coarse(quotient.value.value).to_string())
            }
            "factor" => {
                let pairs = self.pairs(name)?;
                let [own, other] = pairs.last().ok_or("there is no such point")?;
                Ok(words::in_a_formula(own.errors.rms / other.errors.rms))
            }
            "slope" => {
                let curve = self.curve(name.methods.first().ok_or("it needs a method")?)?;
                Ok(match e.fit(curve) {
                    Some(fit) if fit.is_power_law() => {
                        // Not "-0.00".
                        let slope = libm::round(fit.slope * 1e2) / 1e2 + 0.0;
                        format!("{slope:.2}").replace('-', "−")
                    }
                    _ => "no power law".to_owned(),
                })
            }
            "work" => {
                let curve = self.curve(name.methods.first().ok_or("it needs a method")?)?;
                let reached = curve.work_to_reach(HALF_GREY_LEVEL);
                let reached = reached.ok_or("half a grey level is out of reach")?;
                let work = words::count(reached.work);
                Ok(if reached.is_extrapolated {
                    format!("{work}, extrapolated")
                } else {
                    work
                })
            }
            "saved" => self.saved(name),
            _ => Err(format!("there is no figure \"{quantity}\"")),
        }
    }

    /// The milliseconds that a method takes more than the one before it, in an experiment about work
    /// that is left out, to the nearest step.
    fn saved(&self, name: &Name) -> Result<String, String> {
        let with = self.curve(name.methods.first().ok_or("it needs a method")?)?;
        let mut curves = self.measured.curves.iter();
        let is_with = |curve: &&Curve| curve.method == with.method;
        let after = curves.clone().skip(1).position(|curve| is_with(&curve));
        let without = after.and_then(|before| curves.nth(before));
        let without = without.ok_or("there is no method before it")?;
        let [Some(with), Some(without)] = [with, without].map(|curve| curve.points.last()) else {
            return Err("there is no time".to_owned());
        };
        let [with, without] = [with, without].map(|point| point.times.seconds);
        let milliseconds = |seconds: f64| words::coarse(1e3 * seconds);
        let noise = (with.high - without.low).max(without.high - with.low);
        if with.low <= without.high && without.low <= with.high {
            return Ok(format!("below {}", milliseconds(noise)));
        }
        let saved = with.value - without.value;
        let sign = if saved < 0.0 { "−" } else { "" };
        Ok(format!("{sign}{}", milliseconds(saved.abs())))
    }

    /// The point of a method at the parameter, or its last one.
    fn point(&self, name: &Name) -> Result<&'r Point<'a>, String> {
        let curve = self.curve(name.methods.first().ok_or("it needs a method")?)?;
        let is_named = |point: &&Point| name.parameter.is_none_or(|at| is_at(point, at));
        let point = curve.points.iter().rfind(is_named);
        point.ok_or_else(|| format!("{} has no such value of the parameter", curve.method))
    }

    fn error_in_words(&self, point: &Point) -> String {
        match self.measured.experiment.unit {
            Unit::Fraction => words::percent(point.errors.rms),
            _ => words::in_a_formula(point.errors.rms),
        }
    }

    /// A table with a row for each value of the parameter, and a column for each method.
    fn table_of_errors(&self) -> String {
        let measured = self.measured;
        let mut table = format!("| {} |", measured.experiment.parameter);
        for curve in &measured.curves {
            let _ = write!(table, " {} |", curve.method);
        }
        table += "\n|---:|";
        table += &"---:|".repeat(measured.curves.len());
        for parameter in measured.parameters() {
            let _ = write!(table, "\n| {} |", compact_power(parameter));
            for curve in &measured.curves {
                let is_here = |point: &&Point| point.parameter == parameter;
                let error = curve.points.iter().find(is_here);
                let error = error.map_or(String::new(), |point| self.error_in_words(point));
                let _ = write!(table, " {error} |");
            }
        }
        table
    }
}

/// Whether the parameter of a point is the one in these words, to two digits.
fn is_at(point: &Point, words: &str) -> bool {
    let number: f64 = words.parse().unwrap_or(f64::NAN);
    let on = point.on(Axis::Parameter);
    on == number || (on / number - 1.0).abs() < 0.05
}

/// A name in lower case, with dashes between its words.
fn dashed(name: &str) -> String {
    let mut dashed = String::new();
    for letter in name.to_lowercase().chars() {
        if letter.is_alphanumeric() || letter == '.' {
            dashed.push(letter);
        } else if !dashed.ends_with('-') {
            dashed.push('-');
        }
    }
    dashed.trim_matches('-').to_owned()
}
