//! Results in the forms that people, spreadsheets and learning platforms read.

mod classroom50;
mod csv;
mod gradescope;
mod junit;
mod table;

use std::fs;
use std::path::Path;

use super::class::mistakes;
use super::outcome::Graded;
use crate::files::with_path;

/// The most characters of a message.
const MESSAGE: usize = 2000;

/// The forms of results.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// For people: the results, and the mistakes of the class
    Table,
    /// A row for each exercise of each submission
    Csv,
    /// A row for each submission
    Totals,
    /// A row for each mistake of the class
    Mistakes,
    /// For Artemis, GitLab and Jenkins
    Junit,
    /// Of one submission
    Gradescope,
    /// Of one submission
    Classroom50,
}

/// The forms for a class, and their files.
const OF_CLASS: [(Format, &str); 5] = [
    (Format::Table, "table.txt"),
    (Format::Csv, "results.csv"),
    (Format::Totals, "totals.csv"),
    (Format::Mistakes, "mistakes.csv"),
    (Format::Junit, "junit.xml"),
];

impl Format {
    /// The name in the command line.
    pub fn name(self) -> String {
        format!("{self:?}").to_lowercase()
    }

    /// Whether a file in this form is about one submission.
    pub fn is_about_one(self) -> bool {
        matches!(self, Self::Gradescope | Self::Classroom50)
    }
}

/// The results in a form.
pub fn text(format: Format, graded: &[Graded]) -> Result<String, String> {
    Ok(match format {
        Format::Table => table::text(graded, &mistakes(graded)?),
        Format::Csv => csv::results(graded),
        Format::Totals => csv::totals(graded),
        Format::Mistakes => csv::mistakes(&mistakes(graded)?),
        Format::Junit => junit::text(graded),
        Format::Gradescope => gradescope::text(graded),
        Format::Classroom50 => classroom50::text(graded),
    })
}

/// Writes the results into a folder, in each form for a class.
pub fn write_all(folder: &Path, graded: &[Graded]) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(with_path(folder))?;
    for (format, name) in OF_CLASS {
        let file = folder.join(name);
        fs::write(&file, text(format, graded)?).map_err(with_path(&file))?;
    }
    Ok(())
}

/// The beginning of a message, without control characters, which not all formats can express.
fn message(text: &str) -> String {
    let mut message = String::new();
    for c in text.chars().take(MESSAGE) {
        message.push(if c.is_control() && c != '\n' { ' ' } else { c });
    }
    message
}

/// A text of JSON, in quotes.
fn json(text: &str) -> String {
    let text = message(text).replace('\\', "\\\\").replace('"', "\\\"");
    format!("\"{}\"", text.replace('\n', "\\n"))
}

#[cfg(test)]
mod tests {
    use std::process::Command;

    use super::super::outcome::{Cause, Judged, Outcome, State};
    use super::*;

    /// Reads all formats, and compares what they say.
    const READER: &str = include_str!("../../handout/read_results.py");

    /// A submission with a right file, a wrong one for which there are these points, and two copies
    /// of a file.
    fn submission(points_in_part: f64) -> Graded {
        let course = crate::exercise::read_all().unwrap();
        let wrong = Outcome {
            state: State::Wrong,
            message: "a < b & \"c\"\nsecond line, \u{e4}\u{1b}".to_owned(),
            fraction: points_in_part,
            cause: Some(Cause::Known("=1+1".to_owned())),
        };
        let outcomes = [
            (Outcome::right(), 2.0, 2.0),
            (wrong, 1.0, points_in_part),
            (Outcome::needs_a_look("2 copies"), 1.0, 0.0),
        ];
        let mut results = Vec::new();
        for (exercise, (outcome, most, points)) in course.iter().zip(outcomes) {
            results.push(Judged {
                exercise,
                file: format!("ada.zip/{}.rs", exercise.name),
                outcome,
                most,
                points,
            });
        }
        Graded {
            name: "=ada".to_owned(),
            results,
        }
    }

    #[test]
    fn python_reads_all_formats() {
        let mut python = Command::new("python3");
        python.args(["-c", READER]);
        for (format, points_in_part) in [
            (Format::Table, 0.75),
            (Format::Csv, 0.75),
            (Format::Totals, 0.75),
            (Format::Mistakes, 0.75),
            (Format::Junit, 0.75),
            (Format::Gradescope, 0.75),
            // It has whole points only.
            (Format::Classroom50, 0.0),
        ] {
            let graded = [submission(points_in_part)];
            python.arg(text(format, &graded).unwrap());
        }
        match python.status() {
            Ok(status) => assert!(status.success()),
            Err(_) => eprintln!("skipped: without python3 nobody reads the results"),
        }
    }
}
