//! Answers of libraries, as their adapters write them, and the table of all.

use std::collections::{BTreeMap, HashMap};
use std::fmt::Write;

use crate::{
    CASES, Case, DOUBLE, Found, Mistake, SINGLE, SINGLE_CASES, Tally, Verdict, judge, read,
};

/// What is wrong with a file of results.
#[derive(Debug, thiserror::Error)]
pub enum Problem {
    /// The cases cannot be read.
    #[error(transparent)]
    Cases(#[from] Mistake),
    /// A line is none of a result.
    #[error("the line {0:?} is not an id and miss or a number")]
    Line(String),
    /// The first two lines are not those of a result.
    #[error("the first lines must be # with the library's name, and # single or # double")]
    Head,
    /// There is no such case.
    #[error("there is no case {0}")]
    Case(String),
}

/// An answer with its verdict.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The case.
    pub case: Case,
    /// What the library found.
    pub found: Found,
    /// The verdict.
    pub verdict: Verdict,
}

/// What the first lines of a file of results say.
struct Head<'a> {
    title: &'a str,
    is_single: bool,
}

fn head(text: &str) -> Result<Head<'_>, Problem> {
    let mut lines = text.lines().map(|line| line.strip_prefix("# "));
    let (title, precision) = (lines.next().flatten(), lines.next().flatten());
    match (title, precision) {
        (Some(title), Some(precision @ ("single" | "double"))) => Ok(Head {
            title,
            is_single: precision == "single",
        }),
        _ => Err(Problem::Head),
    }
}

/// Judges the text of a file of results.
pub fn judged(text: &str) -> Result<Vec<Judged>, Problem> {
    let Head { is_single, .. } = head(text)?;
    let (cases, unit) = if is_single {
        (SINGLE_CASES, SINGLE)
    } else {
        (CASES, DOUBLE)
    };
    let mut by_id = HashMap::new();
    for case in read(cases)? {
        by_id.insert(case.question.id.clone(), case);
    }
    let mut all = Vec::new();
    for line in text.lines().skip(2) {
        let (id, answer) = line
            .split_once(' ')
            .ok_or_else(|| Problem::Line(line.to_owned()))?;
        let found = match answer {
            "miss" => None,
            t => Some(t.parse().map_err(|_| Problem::Line(line.to_owned()))?),
        };
        let case = by_id
            .remove(id)
            .ok_or_else(|| Problem::Case(id.to_owned()))?;
        all.push(Judged {
            verdict: judge(&case, found, unit),
            found,
            case,
        });
    }
    Ok(all)
}

/// The rows of the table: from what computes like the lesson to what does not.
const ORDER: [&str; 12] = [
    "lesson",
    "engine",
    "woop-compensated",
    "moeller-trumbore",
    "protocol",
    "parry",
    "bvh",
    "embree",
    "open3d",
    "mitsuba",
    "mitsuba-robust",
    "three-mesh-bvh",
];

/// The table of all results, which a function reads by their names: right of asked answers, and the wrong ones
/// of each family.
pub fn table(read_results: impl Fn(&str) -> Option<String>) -> Result<String, Problem> {
    let mut text = String::from(
        "| who answers | right decisions | right values | wrong, by family |\n|---|---|---|---|\n",
    );
    for name in ORDER {
        let Some(results) = read_results(name) else {
            continue;
        };
        let mut all = Tally::default();
        let mut families: BTreeMap<String, Tally> = BTreeMap::new();
        for Judged { case, verdict, .. } in judged(&results)? {
            all.add(verdict);
            let family = families.entry(case.question.family).or_default();
            family.add(verdict);
        }
        let mut wrong = Vec::new();
        for (family, tally) in families {
            if tally.right < tally.asked {
                wrong.push(format!("{family}\u{a0}{}", tally.asked - tally.right));
            }
        }
        let Head { title, is_single } = head(&results)?;
        let precision = if is_single { " (single)" } else { "" };
        // Spaces that do not break keep the numbers in one line. A `String` takes all.
        let _ = writeln!(
            text,
            "| {title}{precision} | {}\u{a0}of\u{a0}{} | {}\u{a0}of\u{a0}{} | {} |",
            all.right_decisions,
            all.decisions,
            all.right_values,
            all.values,
            wrong.join(", "),
        );
    }
    Ok(text)
}
