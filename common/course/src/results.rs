//! The results: a table of all students for a spreadsheet, and a text for each student.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::fs;
use std::path::Path;

use learn::files::with_path;

use crate::outcome::{Graded, Judged, State};
use crate::picture_page::page;

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
    "file",
    "note",
    "message",
];

/// Writes `results.csv` and a text for each student, under the student's name.
pub fn write(folder: &Path, graded: &[Graded]) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(with_path(folder))?;
    let write = |name: &str, text: &str| {
        let file = folder.join(name);
        fs::write(&file, text).map_err(with_path(&file))
    };
    write("results.csv", &table(graded))?;
    if let Some(page) = page(graded) {
        write("pictures.html", &page)?;
    }
    let mut taken = BTreeSet::new();
    for student in graded {
        let mut name = file_name(&student.name);
        while !taken.insert(name.to_lowercase()) {
            name.push('_');
        }
        write(&format!("{name}.txt"), &text(student))?;
    }
    Ok(())
}

/// A name for a file, which is in no other folder.
pub fn file_name(name: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || " -_().,".contains(c);
    let name: String = name
        .chars()
        .map(|c| if is_plain(c) { c } else { '_' })
        .collect();
    name.trim_start_matches('.').to_owned()
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
    for judged in &student.results {
        let Judged {
            name,
            file,
            note,
            outcome,
            ..
        } = judged;
        let _ = write!(text, "  {name}: {}", outcome.state.words());
        for about in [file, note] {
            if !about.is_empty() {
                let _ = write!(text, ", {about}");
            }
        }
        text.push('\n');
        for line in message(&outcome.message).lines() {
            let _ = writeln!(text, "      {line}");
        }
    }
    text
}

/// A row for each exercise of each student, in the form of RFC 4180.
fn table(graded: &[Graded]) -> String {
    let mut table = row(&COLUMNS);
    for student in graded {
        for judged in &student.results {
            let outcome = &judged.outcome;
            let fraction = match outcome.state {
                State::NeedsALook => String::new(),
                // A wrong answer of a thousand is no full mark.
                _ => ((outcome.fraction * 100.0).floor() / 100.0).to_string(),
            };
            table += &row(&[
                &student.name,
                judged.stage,
                &judged.name,
                outcome.state.words(),
                &fraction,
                &outcome.mistake,
                &judged.file,
                &judged.note,
                &outcome.message,
            ]);
        }
    }
    table
}

fn row(cells: &[&str]) -> String {
    let mut row = Vec::new();
    for cell in cells {
        let mut cell = message(cell);
        // A spreadsheet computes no cell that begins with a quote.
        if cell.starts_with(['=', '+', '-', '@']) {
            cell.insert(0, '\'');
        }
        row.push(format!("\"{}\"", cell.replace('"', "\"\"")));
    }
    row.join(",") + "\r\n"
}

/// The beginning of a message, without control characters.
fn message(text: &str) -> String {
    let shown = |c: char| if c.is_control() && c != '\n' { ' ' } else { c };
    text.chars().take(MESSAGE).map(shown).collect()
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
        let judged = Judged {
            stage: "a04-intersections",
            name: "sphere".to_owned(),
            file: "sphere.rs".to_owned(),
            pictures: Vec::new(),
            note: "late".to_owned(),
            outcome,
        };
        let student = |results| Graded {
            name: "../Ada".to_owned(),
            results,
        };
        let graded = [student(vec![judged]), student(Vec::new())];
        let row = "\"../Ada\",\"a04-intersections\",\"sphere\",\"wrong\",\"0.99\",\"'=1+1\",\
                   \"sphere.rs\",\"late\",\"a \"\"b\"\"\nc \"\r\n";
        assert!(table(&graded).ends_with(row), "{}", table(&graded));
        let text = "../Ada: 1 wrong\n  sphere: wrong, sphere.rs, late\n      a \"b\"\n      c \n";
        assert_eq!(super::text(&graded[0]), text);

        let folder = tempfile::tempdir().unwrap();
        write(folder.path(), &graded).unwrap();
        let mut names = Vec::new();
        for entry in fs::read_dir(folder.path()).unwrap() {
            names.push(entry.unwrap().file_name().into_string().unwrap());
        }
        names.sort();
        assert_eq!(names, ["_Ada.txt", "_Ada_.txt", "results.csv"]);
    }
}
