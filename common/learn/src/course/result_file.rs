//! Files of results, as learning platforms read them.
//!
//! A format is a template of six lines: the beginnings of the file and of a submission, a right
//! and a wrong exercise, and the ends of the submission and of the file. A `$name` in a line is a
//! value, or a variable of the environment.

use std::{array, env};

use super::grade::Graded;

/// How special characters are written.
type Written = &'static [(char, &'static str)];
const JSON: Written = &[('"', "\\\""), ('\\', "\\\\"), ('\n', "\\n")];

/// Formats: name, separator of exercises, end of a line, special characters, and template. CSV is
/// that of RFC 4180; Gradescope reads
/// <https://gradescope-autograders.readthedocs.io/en/latest/specs/>, and Classroom 50
/// <https://github.com/foundation50/classroom50/wiki/Advanced-Autograding>, whose runner sets the
/// variables.
#[rustfmt::skip]
pub const FORMATS: [(&str, &str, &str, Written, &str); 5] = [
    ("table", "", "\n", &[('\n', "\n        ")],
        include_str!("../../handout/results/table.txt")),
    ("csv", "", "\r\n", &[('"', "\"\"")],
        include_str!("../../handout/results/results.csv")),
    ("junit", "", "\n", &[('&', "&amp;"), ('<', "&lt;"), ('>', "&gt;"), ('"', "&quot;")],
        include_str!("../../handout/results/junit.xml")),
    ("gradescope", ",", "\n", JSON, include_str!("../../handout/results/gradescope.json")),
    ("classroom50", ",", "\n", JSON, include_str!("../../handout/results/classroom50.json")),
];

/// The most characters of a message.
const MESSAGE: usize = 2000;

/// The results in a format.
pub fn text(format: &str, graded: &[Graded]) -> String {
    let format = FORMATS.iter().find(|(name, ..)| *name == format);
    let (_, separator, end_of_line, written, template) = format.unwrap_or(&FORMATS[0]);
    let mut template = template.lines();
    let [head, before, right, wrong, after, end] =
        array::from_fn(|_| template.next().unwrap_or_default());
    let mut lines = vec![head.to_owned()];
    for Graded { name, results } in graded {
        let all = results.len();
        let right_ones = results.iter().filter(|(_, verdict)| verdict.is_ok());
        let points = right_ones.count();
        let value = |word: &str| match word {
            // A spreadsheet computes no cell that begins with a quote.
            "cell" if name.starts_with(['=', '+', '-', '@']) => format!("'{name}"),
            "cell" | "submission" => name.clone(),
            "all" => all.to_string(),
            "points" => points.to_string(),
            "failures" => (all - points).to_string(),
            variable => env::var(variable).unwrap_or_default(),
        };
        let exercises = results.iter().map(|(e, verdict)| {
            let line = if verdict.is_ok() { right } else { wrong };
            let message = verdict.as_ref().err().map_or("", String::as_str);
            let message = message.chars().take(MESSAGE).collect::<String>();
            filled(line, written, |word| match word {
                "stage" => e.stage.to_owned(),
                "exercise" => e.name.to_owned(),
                "column" => format!("{:18}", e.name),
                "title" => e.title.to_owned(),
                "message" => message.clone(),
                "first" => message.lines().take(1).collect(),
                _ => value(word),
            })
        });
        let exercises: Vec<_> = exercises.collect();
        lines.push(filled(before, written, value));
        lines.push(exercises.join(&[*separator, end_of_line].concat()));
        lines.push(filled(after, written, value));
    }
    lines.push(end.to_owned());
    lines.retain(|line| !line.is_empty());
    lines.join(end_of_line) + end_of_line
}

/// A line of a template with its values, without control characters, which not all formats can
/// express.
fn filled(line: &str, written: Written, value: impl Fn(&str) -> String) -> String {
    let escaped = |c: char| match written.iter().find(|(special, _)| *special == c) {
        Some((_, written)) => (*written).to_owned(),
        None if c.is_control() && c != '\n' => " ".to_owned(),
        None => c.to_string(),
    };
    let mut pieces = line.split('$');
    let mut filled = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let end = piece.find(|c: char| c != '_' && !c.is_alphabetic());
        let (word, rest) = piece.split_at(end.unwrap_or(piece.len()));
        filled.extend(value(word).chars().map(escaped));
        filled += rest;
    }
    filled
}

#[cfg(test)]
mod tests {
    use std::process::Command;

    use super::*;

    /// Reads all formats, and compares what they say.
    const READER: &str = include_str!("../../handout/read_results.py");

    #[test]
    fn python_reads_all_formats() {
        let course = crate::exercise::read_all().unwrap();
        let wrong = "a < b & \"c\"\nsecond line, \u{e4}".to_owned();
        let graded = [Graded {
            name: "=ada".to_owned(),
            results: course.iter().zip([Ok(()), Err(wrong)]).collect(),
        }];
        let mut python = Command::new("python3");
        python.args(["-c", READER]);
        let texts = FORMATS.map(|(format, ..)| text(format, &graded));
        match python.args(texts).status() {
            Ok(status) => assert!(status.success()),
            Err(_) => eprintln!("skipped: without python3 nobody reads the results"),
        }
    }
}
