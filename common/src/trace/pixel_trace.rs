//! `PixelTrace`: all numbers behind a pixel, as text and as JSON.

use std::collections::BTreeSet;
use std::fmt;

use crate::steps::{Outcome, Step, StepKind};
use crate::{Color, Transfer, text};

/// A value in a trace.
pub(crate) struct Value<'a> {
    /// Its place, by the names of its steps and its symbol.
    pub place: String,
    /// Its step.
    pub step: &'a Step,
    /// Its symbol.
    pub symbol: &'static str,
    /// Its numbers.
    pub numbers: &'a [f64],
}

/// The steps from a pixel to its colour.
#[derive(Clone, Debug, PartialEq)]
pub struct PixelTrace {
    /// Column and row, counted from 0 in the upper left corner.
    pub pixel: [u32; 2],
    /// The linear colour: the mean over the samples.
    pub color: Color,
    /// The steps in their order.
    pub steps: Vec<Step>,
}

impl PixelTrace {
    /// All values. A test without `t` counts as a hit at infinity.
    pub(crate) fn values(&self) -> impl Iterator<Item = Value<'_>> {
        let mut path: Vec<&str> = Vec::new();
        self.steps.iter().flat_map(move |step| {
            path.truncate(step.level);
            path.push(&step.name);
            let place = path.join(", ");
            let is_missed = step.kind == StepKind::Test && step.value::<1>("t").is_none();
            let missed = is_missed.then_some(("t", &[f64::INFINITY][..]));
            let values = step.values.iter().map(|(name, value)| (*name, &**value));
            let values = missed.into_iter().chain(values);
            values.map(move |(symbol, numbers)| Value {
                place: format!("{place}: {symbol}"),
                step,
                symbol,
                numbers,
            })
        })
    }

    /// The trace for programs: `pixel`, `color`, `bytes` and `steps`, one on a line, whose
    /// values are lists of numbers. A number that JSON does not have is `null`.
    #[must_use]
    pub fn to_json(&self, transfer: Transfer) -> String {
        let numbers = |numbers: &[f64]| {
            let text = format!("{numbers:?}").replace("-inf", "null");
            text.replace("inf", "null").replace("NaN", "null")
        };
        let step = |step: &Step| {
            let (level, kind, name, about) =
                (step.level, step.kind.word(), &step.name, &step.about);
            let (outcome, section) = (step.outcome.to_string(), step.section);
            let values = step.values.iter();
            let values = values.map(|(symbol, value)| format!("{symbol:?}: {}", numbers(value)));
            let values = values.collect::<Vec<_>>().join(", ");
            // Names have no characters that Rust and JSON escape differently.
            format!(
                r#"{{"level": {level}, "kind": {kind:?}, "name": {name:?}, "about": {about:?}, "outcome": {outcome:?}, "values": {{{values}}}, "section": {section:?}}}"#
            )
        };
        let steps = self.steps.iter().map(step).collect::<Vec<_>>().join(",\n");
        let (pixel, bytes) = (self.pixel, transfer.bytes(self.color));
        let color = numbers(&self.color.channels());
        format!(
            r#"{{"pixel": {pixel:?}, "color": {color}, "bytes": {bytes:?}, "steps": [
{steps}
]}}"#
        )
    }
}

/// A number with at most four significant digits, or a point, vector or colour of them.
#[must_use]
pub fn digits(numbers: &[f64]) -> String {
    let all: Vec<_> = numbers
        .iter()
        .map(|number| text::rounded(*number, 4))
        .collect();
    match &*all {
        [number] => number.clone(),
        _ => format!("({})", all.join(", ")),
    }
}

/// So many objects beside a ray, one after the other, are listed; more are counted.
const LISTED: usize = 20;

/// The steps, one on a line and indented by their level, and the sections that explain them.
impl fmt::Display for PixelTrace {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let indented = |step: &Step| "  ".repeat(step.level) + &step.name;
        let widths = self.steps.iter().map(|step| indented(step).len());
        let width = widths.max().unwrap_or(0);
        let are_beside = |one: &Step, next: &Step| {
            [one, next]
                .iter()
                .all(|step| step.outcome == Outcome::Missed)
                && one.level == next.level
        };
        for steps in self.steps.chunk_by(are_beside) {
            if steps.len() > LISTED {
                let indent = "  ".repeat(steps[0].level);
                let count = steps.len();
                writeln!(f, "{indent}{count} objects  {}", Outcome::Missed)?;
                continue;
            }
            for step in steps {
                let words = step.words().map(|word| format!("  {word}"));
                writeln!(f, "{:width$}{}", indented(step), words.collect::<String>())?;
            }
        }
        let sections: BTreeSet<_> = self.steps.iter().map(|step| step.section).collect();
        let sections: Vec<_> = sections.into_iter().collect();
        write!(f, "explained in book/src/\n  {}", sections.join("\n  "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_objects_beside_a_ray_are_counted_and_few_are_listed() {
        let step = |name: String, outcome| Step {
            outcome,
            ..Step::new(StepKind::Test, name, "")
        };
        let beside = |count| (0..count).map(|i| step(format!("ball {i}"), Outcome::Missed));
        let mut trace = PixelTrace {
            pixel: [0, 0],
            color: Color::BLACK,
            steps: beside(20).collect(),
        };
        trace.steps.push(step("wall".to_owned(), Outcome::Hit));
        trace.steps.extend(beside(9990));
        let text = trace.to_string();
        let lines: Vec<_> = text.lines().collect();
        let words = |line: &str| line.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(words(lines[0]), "ball 0 beside the ray");
        assert_eq!(words(lines[20]), "wall hit");
        assert_eq!(words(lines[21]), "9990 objects beside the ray");
    }

    #[test]
    fn json_has_all_digits_and_text_has_four() {
        let numbers = [1.0 / 3.0, f64::INFINITY, 1.5e-7];
        let trace = PixelTrace {
            pixel: [1, 2],
            color: Color::gray(0.5),
            steps: vec![
                Step::new(StepKind::Mean, "a", "")
                    .about("Sphere")
                    .with("x", numbers),
            ],
        };
        let json = [
            r#"{"pixel": [1, 2], "color": [0.5, 0.5, 0.5], "bytes": [128, 128, 128], "steps": ["#,
            r#"{"level": 0, "kind": "mean", "name": "a", "about": "Sphere", "outcome": "", "values": {"x": [0.3333333333333333, null, 1.5e-7]}, "section": ""}"#,
            "]}",
        ];
        assert_eq!(trace.to_json(Transfer::Linear), json.join("\n"));
        let text = trace.to_string();
        assert!(text.starts_with("a  x (0.3333, inf, 1.5e-7)\n"), "{text}");
    }
}
