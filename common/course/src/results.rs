//! The results: a table of all students, for people and for programs, and a text for each student.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use common::text;
use learn::files::with_path;

use crate::outcome::{Graded, Judged, State};
use crate::picture_page::page;
use crate::spreadsheet::spreadsheet;

/// The most characters of a message.
const MESSAGE: usize = 2000;

/// The columns of the table.
const COLUMNS: [&str; 9] = [
    "student",
    "stage",
    "exercise",
    "state",
    "right_answers",
    "mistake",
    "same_code_as",
    "file",
    "message",
];

/// The column of numbers.
const RIGHT_ANSWERS: usize = 4;

/// Whether a folder is missing or empty, so that nothing in it is lost.
pub fn is_free(folder: &Path) -> bool {
    let is_empty = fs::read_dir(folder).is_ok_and(|mut files| files.next().is_none());
    is_empty || !folder.exists()
}

/// Writes the table for people and for programs, and a text for each student, under the student's name.
pub fn write(folder: &Path, graded: &[Graded]) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(with_path(folder))?;
    let write = |name: &str, bytes: &[u8]| {
        let file = folder.join(name);
        fs::write(&file, bytes).map_err(with_path(&file))
    };
    let table = table(graded);
    write("results.csv", csv(&table).as_bytes())?;
    let sheet = spreadsheet(&table, RIGHT_ANSWERS).map_err(|error| error.to_string())?;
    write("results.xlsx", &sheet)?;
    if let Some(page) = page(folder, graded) {
        write("pictures.html", page.as_bytes())?;
    }
    for student in graded {
        let name = format!("{}.txt", student.file_name);
        write(&name, text(student).as_bytes())?;
    }
    Ok(())
}

/// What a student reads: a line for each exercise, and the messages.
pub fn text(student: &Graded) -> String {
    let mut counts = Vec::new();
    for state in State::ALL {
        let states = student.results.iter().map(|judged| judged.outcome.state);
        match states.filter(|found| *found == state).count() {
            0 => {}
            count => counts.push(format!("{count} {}", state.words())),
        }
    }
    let mut text = format!("{}: {}\n", student.name, counts.join(", "));
    // A message about several exercises, such as that a zip file does not open, is printed once.
    let is_same = |a: &Judged, b: &Judged| a.file == b.file && a.outcome == b.outcome;
    for judged in student.results.chunk_by(is_same) {
        let names: Vec<_> = judged.iter().map(|judged| &*judged.name).collect();
        let Judged { file, outcome, .. } = &judged[0];
        let _ = write!(text, "  {}: {}", names.join(", "), outcome.state.words());
        if !file.is_empty() {
            let _ = write!(text, ", {file}");
        }
        text.push('\n');
        for line in message(&outcome.message).lines() {
            let _ = writeln!(text, "      {line}");
        }
    }
    text
}

/// A row for each exercise of each student, below the names of the columns.
fn table(graded: &[Graded]) -> Vec<[String; 9]> {
    let mut table = vec![COLUMNS.map(str::to_owned)];
    for student in graded {
        for judged in &student.results {
            let outcome = &judged.outcome;
            let fraction = match outcome.state {
                State::NeedsALook => String::new(),
                // A wrong answer of a thousand is no full mark.
                _ => ((outcome.fraction * 100.0).floor() / 100.0).to_string(),
            };
            let row = [
                &student.name,
                judged.stage,
                &judged.name,
                outcome.state.words(),
                &fraction,
                &outcome.mistake,
                &judged.same_code_as,
                &judged.file,
                &outcome.message,
            ];
            table.push(row.map(message));
        }
    }
    table
}

/// A table in the form of RFC 4180, behind the mark by which Excel knows UTF-8.
fn csv(table: &[[String; 9]]) -> String {
    let mut csv = "\u{feff}".to_owned();
    for row in table {
        let cells = row.each_ref().map(|cell| {
            // A spreadsheet computes no cell that begins with a quote.
            let mark = ["", "'"][usize::from(cell.starts_with(['=', '+', '-', '@']))];
            format!("\"{mark}{}\"", cell.replace('"', "\"\""))
        });
        csv += &cells.join(",");
        csv += "\r\n";
    }
    csv
}

/// The beginning of a message, in which control characters are seen; XML has none, and neither has it the last two.
fn message(message: &str) -> String {
    let beginning: String = message.chars().take(MESSAGE).collect();
    text::visible_lines(&beginning).replace(['\u{fffe}', '\u{ffff}'], " ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outcome::Outcome;

    #[test]
    fn a_spreadsheet_and_a_student_read_the_results() {
        let outcome = Outcome {
            fraction: 0.999,
            mistake: "=1+1".to_owned(),
            ..Outcome::without_answers(State::Wrong, "a \"b\"\nc\u{1b}")
        };
        let judged = |name: &str, file: &str, outcome| Judged {
            stage: "a04-intersections",
            name: name.to_owned(),
            file: file.to_owned(),
            files: Vec::new(),
            same_code_as: String::new(),
            outcome,
        };
        let absent = Outcome::without_answers(State::NotHandedIn, "");
        let graded = [Graded {
            name: "Ada B.".to_owned(),
            file_name: "ada".to_owned(),
            results: vec![
                judged("plane", "", absent.clone()),
                judged("torus", "", absent),
                judged("sphere", "sphere.rs", outcome),
            ],
        }];
        let row = "\"Ada B.\",\"a04-intersections\",\"sphere\",\"wrong\",\"0.99\",\"'=1+1\",\
                   \"\",\"sphere.rs\",\"a \"\"b\"\"\nc\\u{1b}\"\r\n";
        let folder = tempfile::tempdir().unwrap();
        assert!(is_free(folder.path()) && is_free(&folder.path().join("new")));
        write(folder.path(), &graded).unwrap();
        for used in [folder.path(), &folder.path().join("results.csv")] {
            assert!(!is_free(used), "{used:?}");
        }
        let csv = fs::read_to_string(folder.path().join("results.csv")).unwrap();
        assert!(csv.starts_with("\u{feff}\"student\""), "{csv}");
        assert!(csv.ends_with(row), "{csv}");
        let text = "Ada B.: 1 wrong, 2 not handed in\n  plane, torus: not handed in\n  \
                    sphere: wrong, sphere.rs\n      a \"b\"\n      c\\u{1b}\n";
        assert_eq!(
            fs::read_to_string(folder.path().join("ada.txt")).unwrap(),
            text
        );
    }
}
