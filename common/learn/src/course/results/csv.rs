//! Tables for spreadsheets and learning platforms, in the form of RFC 4180.

use super::super::class::ClassMistake;
use super::super::outcome::{Graded, State};
use super::message;

/// A row for each exercise of each submission. The points are empty where it needs a look.
pub fn results(graded: &[Graded]) -> String {
    let mut text = row(&[
        "submission",
        "stage",
        "exercise",
        "file",
        "state",
        "points",
        "max_points",
        "message",
    ]);
    for submission in graded {
        for judged in &submission.results {
            let points = match judged.outcome.state {
                State::NeedsALook => String::new(),
                _ => judged.points.to_string(),
            };
            text += &row(&[
                &submission.name,
                judged.exercise.stage,
                judged.exercise.name,
                &judged.file,
                judged.outcome.state.words(),
                &points,
                &judged.most.to_string(),
                &judged.outcome.message,
            ]);
        }
    }
    text
}

/// A row for each submission.
pub fn totals(graded: &[Graded]) -> String {
    let mut text = row(&[
        "submission",
        "points",
        "max_points",
        "right",
        "wrong",
        "not_handed_in",
        "needs_a_look",
    ]);
    for submission in graded {
        let count = |state| submission.count(state).to_string();
        text += &row(&[
            &submission.name,
            &submission.points().to_string(),
            &submission.most().to_string(),
            &count(State::Right),
            &count(State::Wrong),
            &count(State::NotHandedIn),
            &count(State::NeedsALook),
        ]);
    }
    text
}

/// A row for each mistake of the class.
pub fn mistakes(mistakes: &[ClassMistake]) -> String {
    let mut text = row(&[
        "stage",
        "exercise",
        "submissions",
        "kind",
        "mistake",
        "names",
    ]);
    for mistake in mistakes {
        text += &row(&[
            mistake.exercise.stage,
            mistake.exercise.name,
            &mistake.names.len().to_string(),
            mistake.kind(),
            mistake.words(),
            &mistake.names.join(", "),
        ]);
    }
    text
}

/// A row. Only numbers and plain names stand without quotes.
fn row(cells: &[&str]) -> String {
    let mut text = String::new();
    for (number, value) in cells.iter().enumerate() {
        if number > 0 {
            text += ",";
        }
        text += &cell(value);
    }
    text + "\r\n"
}

fn cell(value: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || ['_', '-', '.'].contains(&c);
    let mut value = message(value);
    // A spreadsheet computes no cell that begins with a quote.
    if value.starts_with(['=', '+', '-', '@']) {
        value.insert(0, '\'');
    }
    if value.chars().all(is_plain) {
        return value;
    }
    format!("\"{}\"", value.replace('"', "\"\""))
}
