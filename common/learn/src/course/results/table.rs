//! A table for people: the results of each submission, and the mistakes of the class.

use super::super::class::ClassMistake;
use super::super::outcome::{Graded, Judged, State};
use super::message;

pub fn text(graded: &[Graded], mistakes: &[ClassMistake]) -> String {
    let mut text = String::new();
    for submission in graded {
        let (points, most) = (submission.points(), submission.most());
        let name = &submission.name;
        let head = match submission.count(State::NeedsALook) {
            0 => format!("{name}: {points} of {most}\n"),
            count => format!("{name}: {points} of {most}, and {count} need a look\n"),
        };
        text.push_str(&head);
        for judged in &submission.results {
            text += &row(judged);
        }
    }
    // One student is no class.
    if graded.len() > 1 && !mistakes.is_empty() {
        text += "\nmistakes of the class\n";
        for mistake in mistakes {
            text += &row_of_class(mistake, graded.len());
        }
    }
    text
}

fn row(judged: &Judged) -> String {
    let points = match judged.outcome.state {
        State::NeedsALook => "?".to_owned(),
        _ => judged.points.to_string(),
    };
    let name = judged.exercise.name;
    let words = indented(&judged.outcome.message, 8);
    let file = match judged.file.as_str() {
        "" => String::new(),
        file => format!("  ({file})"),
    };
    match words.split_once('\n') {
        Some((first, rest)) => format!("  {points:4} {name:18} {first}{file}\n{rest}\n"),
        None => format!("  {points:4} {name:18} {words}{file}\n"),
    }
}

fn row_of_class(mistake: &ClassMistake, all: usize) -> String {
    let name = mistake.exercise.name;
    let count = mistake.names.len();
    let kind = match mistake.kind() {
        "known" => "",
        "unknown" if count > 1 => "unknown, with the same answers: ",
        "unknown" => "unknown: ",
        _ => "no answers: ",
    };
    let words = indented(mistake.words(), 8);
    let names = mistake.names.join(", ");
    format!("  {name:18} {count} of {all}: {kind}{words}\n        {names}\n")
}

/// Lines of which all but the first are indented.
fn indented(text: &str, by: usize) -> String {
    let indent = " ".repeat(by);
    message(text).replace('\n', &format!("\n{indent}"))
}
