//! The recording of the book: one measurement of all experiments, from which its pages take their figures.
//!
//! A page names a figure by an anchor instead of typing it:
//!
//! | anchor | becomes |
//! |---|---|
//! | `{{recorded time a04.sphere-far.compensated/stable}}` | the quotient of the times of two methods |
//! | `{{recorded error a04.sphere-far.stable@512}}` | the root mean square error, or the fraction of wrong answers |
//! | `{{recorded slope a04.sphere-far.stable}}` | the slope of the curve, or `no power law` |
//! | `{{recorded where}}` | machine, build, commit and date |
//!
//! Methods are named in lower case with dashes, by as many letters as tell them apart. `@` names the value of
//! the parameter, by default the last one that both methods have.

use common::text;

/// A recording.
#[derive(Debug, Default)]
pub struct Recording<'t> {
    /// The lines of its head: keys and words.
    head: Vec<(&'t str, &'t str)>,
    rows: Vec<Row<'t>>,
}

/// The columns that figures need, whichever place they have in the file.
const COLUMNS: [&str; 7] = [
    "experiment",
    "method",
    "parameter",
    "unit",
    "error",
    "seconds",
    "slope",
];

/// A point of a curve.
#[derive(Debug)]
struct Row<'t> {
    /// With its stage, such as `a04.sphere-far`.
    experiment: &'t str,
    method: &'t str,
    parameter: f64,
    unit: &'t str,
    error: f64,
    seconds: f64,
    /// The slope of the curve, or nothing.
    slope: &'t str,
}

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

impl<'t> Recording<'t> {
    /// Reads a file that [`csv`](crate::report::csv) has written. Its columns may be in any order, and
    /// there may be others.
    pub fn parse(text: &'t str) -> Result<Self, String> {
        let mut recording = Self::default();
        let mut places = None;
        for line in text.lines() {
            if let Some(line) = line.strip_prefix("# ") {
                recording.head.extend(line.split_once(": "));
                continue;
            }
            let fields = fields(line);
            match places {
                Some(places) => recording.rows.push(row(&fields, places)?),
                None => places = Some(find_columns(&fields)?),
            }
        }
        Ok(recording)
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
            None if anchor == "where" => Ok(self.place()),
            None => Err("there is no such figure".to_owned()),
            Some((quantity, name)) => self.quantity(quantity, name.trim()),
        };
        figure.map_err(|why| format!("{{{{recorded {anchor}}}}}: {why}"))
    }

    fn place(&self) -> String {
        let mut words = Vec::new();
        for wanted in ["machine", "version", "compiler", "commit", "date"] {
            let found = self.head.iter().find(|(key, _)| *key == wanted);
            words.extend(found.map(|(_, words)| *words));
        }
        words.join("; ")
    }

    /// A quantity of one or two methods: `a04.sphere-far.stable/protocol@512`.
    fn quantity(&self, quantity: &str, name: &str) -> Result<String, String> {
        let (name, at) = match name.split_once('@') {
            Some((name, at)) => (name, Some(at.parse().map_err(|_| "no number behind @")?)),
            None => (name, None),
        };
        let dot = name.match_indices('.').nth(1);
        let (dot, _) = dot.ok_or("a name is STAGE.EXPERIMENT.METHOD")?;
        let (experiment, methods) = (&name[..dot], &name[dot + 1..]);
        let none = "there is no such value of the parameter";
        if quantity == "time" {
            let two = methods.split_once('/');
            let (own, other) = two.ok_or("a time needs two methods, with a / between them")?;
            let others = self.rows(experiment, other, at)?;
            for own in self.rows(experiment, own, at)?.into_iter().rev() {
                let same = |other: &&&Row| other.parameter == own.parameter;
                if let Some(other) = others.iter().find(same) {
                    return Ok(text::rounded(own.seconds / other.seconds, 2));
                }
            }
            return Err(none.to_owned());
        }
        let row = self.rows(experiment, methods, at)?.pop().ok_or(none)?;
        match quantity {
            "error" if row.unit == "all = 1" => {
                Ok(format!("{} %", in_a_formula(100.0 * row.error)))
            }
            "error" => Ok(in_a_formula(row.error)),
            "slope" => Ok(slope(row)),
            _ => Err("there is no such figure".to_owned()),
        }
    }

    /// The rows of a method at a value of the parameter, or at all values. The method has this name in
    /// lower case with dashes, or alone begins with it.
    fn rows(&self, experiment: &str, name: &str, at: Option<f64>) -> Result<Vec<&Row<'t>>, String> {
        let of_experiment = self.rows.iter().filter(|row| row.experiment == experiment);
        let mut rows: Vec<_> = of_experiment.collect();
        let mut known: Vec<_> = rows.iter().map(|row| dashed(row.method)).collect();
        known.dedup();
        let mut named = known.clone();
        named.retain(|method| method.starts_with(name));
        let method = match &named[..] {
            [only] => only,
            _ if known.iter().any(|method| method == name) => name,
            _ => {
                return Err(format!(
                    "of {experiment}, the methods are {}",
                    known.join(", ")
                ));
            }
        };
        rows.retain(|row| dashed(row.method) == method);
        if let Some(at) = at {
            rows.retain(|row| row.parameter == at || (row.parameter / at - 1.0).abs() < 0.05);
        }
        Ok(rows)
    }
}

/// The places of the columns in the line of their names.
fn find_columns(names: &[&str]) -> Result<[usize; COLUMNS.len()], String> {
    let mut places = [0; COLUMNS.len()];
    for (place, column) in places.iter_mut().zip(COLUMNS) {
        let found = names.iter().position(|name| *name == column);
        *place = found.ok_or_else(|| format!("there is no column {column}"))?;
    }
    Ok(places)
}

fn row<'t>(fields: &[&'t str], places: [usize; COLUMNS.len()]) -> Result<Row<'t>, String> {
    let mut row = [""; COLUMNS.len()];
    for (field, place) in row.iter_mut().zip(places) {
        *field = fields.get(place).ok_or("a row has too few fields")?;
    }
    let number = |field: &str| {
        field
            .parse()
            .map_err(|_| format!("\"{field}\" is no number"))
    };
    let [experiment, method, parameter, unit, error, seconds, slope] = row;
    Ok(Row {
        experiment,
        method,
        parameter: number(parameter)?,
        unit,
        error: number(error)?,
        seconds: number(seconds)?,
        slope,
    })
}

/// The fields of a line, in quotes or not. No field has a quote in it.
fn fields(line: &str) -> Vec<&str> {
    let mut fields = Vec::new();
    let mut rest = Some(line);
    while let Some(line) = rest {
        let (field, behind) = match line.strip_prefix('"').and_then(|line| line.split_once('"')) {
            Some((field, behind)) => (field, behind.strip_prefix(',')),
            None => match line.split_once(',') {
                Some((field, behind)) => (field, Some(behind)),
                None => (line, None),
            },
        };
        fields.push(field);
        rest = behind;
    }
    fields
}

/// The slope of a row with two decimals.
fn slope(row: &Row) -> String {
    match row.slope.parse::<f64>() {
        // Not "-0.00".
        Ok(slope) => format!("{:.2}", libm::round(slope * 1e2) / 1e2 + 0.0).replace('-', "−"),
        Err(_) => "no power law".to_owned(),
    }
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

/// A number with two digits, in the notation of the book's formulas.
fn in_a_formula(number: f64) -> String {
    let rounded = text::rounded(number, 2);
    match rounded.split_once('e') {
        Some((mantissa, power)) => format!(r"${mantissa} \cdot 10^{{{power}}}$"),
        None => rounded,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The columns in an order of their own, and one more than are needed.
    const TEXT: &str = "\
# machine: abacus
# date: 2026-11-26
# commit: 123abc
# a00.far: How far? rms error, against 0; no random numbers
experiment,method,colour,parameter,unit,error,seconds,slope
a00.far,\"plain (ours)\",red,1,t,1e-9,2,
a00.far,\"plain (ours)\",red,2,t,1e-9,1,
a00.far,\"careful, new\",blue,1,t,2.5e-11,6,-0.4996
a00.far,\"careful, new\",blue,2,t,0,0.52,-0.4996
a00.near,\"plain\",red,1,all = 1,0.455,1,
";

    #[test]
    fn anchors_become_figures() {
        let recording = Recording::parse(TEXT).unwrap();
        for (anchor, expected) in [
            ("time a00.far.careful/plain", "0.52"),
            ("time a00.far.careful-new/plain-ours@1", "3"),
            ("error a00.far.careful@1", r"$2.5 \cdot 10^{-11}$"),
            ("error a00.far.careful", "0"),
            ("error a00.near.plain", "46 %"),
            ("slope a00.far.careful", "−0.50"),
            ("slope a00.far.plain", "no power law"),
            ("where", "abacus; 123abc; 2026-11-26"),
        ] {
            let page = format!("It takes {{{{recorded {anchor}}}}} of that.");
            let filled = recording.fill(&page).unwrap();
            assert_eq!(filled, format!("It takes {expected} of that."));
        }
    }

    #[test]
    fn a_figure_that_is_not_recorded_is_an_error() {
        let recording = Recording::parse(TEXT).unwrap();
        for (anchor, expected) in [
            (
                "time a00.far.slow/plain",
                "the methods are plain-ours, careful-new",
            ),
            ("time a00.far.careful", "two methods"),
            ("time a00.far.careful/plain@7", "no such value"),
            ("error a00.far.plain@7", "no such value"),
            ("error a00.far", "STAGE.EXPERIMENT.METHOD"),
            ("weight a00.far.plain", "no such figure"),
        ] {
            let wrong = recording.figure(anchor).unwrap_err();
            assert!(wrong.contains(expected), "{anchor}: {wrong}");
        }
        for (text, expected) in [
            ("a,b\n1\n", "no column experiment"),
            (&TEXT.replace("1e-9", "one"), "\"one\" is no number"),
            (&TEXT.replace(",0.52,-0.4996", ""), "too few fields"),
        ] {
            assert!(
                Recording::parse(text).unwrap_err().contains(expected),
                "{expected}"
            );
        }
    }
}
