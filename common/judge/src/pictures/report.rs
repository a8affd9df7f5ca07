//! What a student reads: the first fact that fails, and all facts.

use std::fmt::Write;

use common::text;

use crate::pictures::fact::Fact;
use crate::pictures::fitted_slope::Axis;
use crate::pictures::judgement::{Judgement, State};
use crate::pictures::line::Line;
use crate::pictures::marked_copy::mark;
use crate::pictures::quantity::{Exact, Quantity};
use crate::pictures::run::Run;
use crate::pictures::values::{Channel, Region};

/// The significant digits of a measured value.
const DIGITS: usize = 6;

impl Judgement<'_> {
    /// The report. The place of the first fact that fails is marked in a copy of its picture.
    #[must_use]
    pub fn report(&self) -> String {
        let mut report = String::new();
        if let Some(fact) = self.first_failure() {
            report += &self.failure(fact);
            report.push('\n');
        }
        report += &self.list();
        report
    }

    /// The first fact that fails, in words: one line for a mark.
    #[must_use]
    pub fn mistake(&self) -> String {
        let Some(fact) = self.first_failure() else {
            return String::new();
        };
        match self.state(fact) {
            State::NotMeasured(problem) => format!("{}: {problem}", fact.name),
            _ => format!("{}: {}", fact.name, fact.says),
        }
    }

    pub(crate) fn state(&self, fact: &Fact) -> &State {
        let place = self.sheet.facts.iter().position(|f| f.name == fact.name);
        &self.states[place.unwrap_or_default()]
    }

    fn failure(&self, fact: &Fact) -> String {
        let mut lines = vec![format!("{}: not yet", fact.name)];
        let mut add = |name: &str, words: &str| lines.push(format!("  {name:9} {words}"));
        add("fact", &fact.says);
        let measured = match self.state(fact) {
            State::Right(measured) | State::Wrong(measured) => Some(measured),
            State::NotMeasured(_) | State::NotAsked => None,
        };
        if let State::NotMeasured(problem) = self.state(fact) {
            add("problem", problem);
        }
        if let Some(measured) = measured {
            let value = text::rounded(measured.value, DIGITS);
            let value = value + &in_picture(fact, measured.value);
            add("measured", &format!("{value}: {}", fact.in_words()));
        }
        // Without a picture, the right value would distract from the problem.
        let Ok(opened) = self.opened(&fact.run) else {
            return lines.join("\n") + "\n";
        };
        let (right, formula) = (text::number(fact.value), &fact.formula);
        let or_less = if fact.or_less { ", or less" } else { "" };
        let right = right + &in_picture(fact, fact.value);
        add("right", &format!("{right} = {formula}{or_less}"));
        let (within, because) = (text::number(fact.within), &fact.because);
        add("within", &format!("{within}, because {because}"));
        add("hint", &fact.hint);
        if fact.theory().is_some() {
            add(
                "errors",
                "`--report` shows them, beside theory and run time",
            );
        }
        add("picture", &text::path(&opened.drawn.file));
        match mark(self, fact, measured) {
            Ok(Some(marked)) => {
                add(
                    "marked",
                    &format!("{}: {}", text::path(&marked.file), marked.words),
                );
            }
            Ok(None) => {}
            Err(error) => add("marked", &error.to_string()),
        }
        lines.join("\n") + "\n"
    }

    fn list(&self) -> String {
        let longest = self.sheet.facts.iter().map(|fact| fact.name.len()).max();
        let longest = longest.unwrap_or_default();
        let mut list = String::new();
        for (fact, state) in self.sheet.facts.iter().zip(&self.states) {
            let word = match state {
                State::Right(_) => "ok",
                State::Wrong(_) | State::NotMeasured(_) => "not",
                State::NotAsked => "not asked",
            };
            let _ = writeln!(list, "{word:9}  {:longest$}  {}", fact.name, fact.says);
        }
        if self.none_counts() {
            let mut counting = Vec::new();
            for fact in &self.sheet.facts {
                if fact.quantity.needs_two_colors() {
                    counting.push(&*fact.name);
                }
            }
            let _ = writeln!(
                list,
                "None counts before one of these holds, because pictures of one colour fulfil the others: {}",
                counting.join(", ")
            );
        }
        list
    }
}

impl Fact {
    /// What is measured where.
    fn in_words(&self) -> String {
        let of = |what: &str, region: &Region| {
            let Region {
                x,
                y,
                width,
                height,
            } = region;
            let (right, bottom) = (x + width - 1, y + height - 1);
            format!("{what} in columns {x} to {right} and rows {y} to {bottom}")
        };
        let on = |what: &str, line: &Line| {
            let [[x, y], [to_x, to_y]] = [line.from, line.to];
            let lines = match line.lines {
                1 => String::new(),
                count => format!(", the mean of {count} lines beside each other"),
            };
            format!("{what} on the line from ({x}, {y}) to ({to_x}, {to_y}){lines}")
        };
        let error = |exact: &Exact| match exact {
            Exact::Number(number) => format!("root mean square difference from {number}"),
            Exact::Columns(_) => "root mean square difference from exact columns".to_owned(),
            Exact::Run(run) => format!("root mean square difference from {}", run.words()),
        };
        let words = match &self.quantity {
            Quantity::Mean(region) => of("mean", region),
            Quantity::Greatest(region) => of("greatest value", region),
            Quantity::Least(region) => of("least value", region),
            Quantity::Alike(region) => of("share of pixels like the pixel below", region),
            Quantity::Autocorrelation(region) => of("greatest autocorrelation", region),
            Quantity::Load(region) => of(
                "greatest share of the work, which is the row from below,",
                region,
            ),
            Quantity::Edge(line) => on("pixels from the beginning to the edge", line),
            Quantity::Width(line) => on("pixels between 10 % and 90 % of the step", line),
            Quantity::Spread { region, exact } => of(&error(exact), region),
            Quantity::Same(other) => format!("pixels that differ from {}", other.words()),
            Quantity::Growth { region, runs } => {
                let runs: Vec<_> = runs.iter().map(Run::words).collect();
                let steps = "greatest difference between the steps of the mean";
                format!(
                    "{}, from picture to picture: {}",
                    of(steps, region),
                    runs.join("; ")
                )
            }
            Quantity::Slope {
                region,
                exact,
                axis,
                ..
            } => {
                let slope = format!("slope of the logarithm of the {}", error(exact));
                let over = match axis {
                    Axis::Logarithm => "the logarithm of the samples",
                    Axis::Linear => "the samples",
                };
                format!("{}, over {over}", of(&slope, region))
            }
        };
        let channel = match self.channel {
            None => "",
            Some(Channel::Red) => ", red",
            Some(Channel::Green) => ", green",
            Some(Channel::Blue) => ", blue",
        };
        format!("{words}{channel} ({})", self.run.words())
    }
}

/// The value as a program that shows pictures has it: a byte, or a point.
fn in_picture(fact: &Fact, value: f64) -> String {
    match &fact.quantity {
        Quantity::Mean(_) | Quantity::Greatest(_) | Quantity::Least(_) => {
            format!(
                " (byte {})",
                text::rounded((value * 2550.0).round() / 10.0, 4)
            )
        }
        Quantity::Edge(line) => {
            let [x, y] = line.point(value, 0.0);
            format!(" (at {x:.1}, {y:.1})")
        }
        _ => String::new(),
    }
}
