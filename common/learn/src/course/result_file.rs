//! Files of results, as learning platforms read them.

use std::env;

use super::grade::{Graded, Outcome};

pub const FORMATS: [&str; 5] = ["table", "csv", "junit", "gradescope", "classroom50"];

/// The results in a format.
pub fn text(format: &str, graded: &[Graded]) -> String {
    let (head, of_one, end): (_, fn(&Graded) -> String, _) = match format {
        "csv" => (COLUMNS, csv, ""),
        "junit" => ("<testsuites>\n", junit, "</testsuites>\n"),
        "gradescope" => ("", gradescope, ""),
        "classroom50" => ("", classroom50, ""),
        _ => ("", table, ""),
    };
    let texts: String = graded.iter().map(of_one).collect();
    [head, &texts, end].concat()
}

/// The points of a submission, and the text of its results.
fn results(graded: &Graded, separator: &str, text: impl Fn(&Outcome) -> String) -> (usize, String) {
    let points = graded.results.iter().map(|o| o.points).sum();
    let texts: Vec<_> = graded.results.iter().map(text).collect();
    (points, texts.join(separator))
}

fn table(graded: &Graded) -> String {
    let (points, results) = results(graded, "", |o| {
        let message = o.message.replace('\n', "\n        ");
        format!("  {}  {:18} {message}\n", o.points, o.exercise.name)
    });
    format!(
        "{}: {points} of {}\n{results}",
        graded.name,
        graded.results.len()
    )
}

const COLUMNS: &str = "submission,stage,exercise,points,max_points,message\r\n";

/// RFC 4180: a field in quotes, whose own quotes are doubled. A leading `'` keeps a
/// spreadsheet from computing a name.
fn csv(graded: &Graded) -> String {
    let field = |text: &str| {
        let is_formula = text.starts_with(['=', '+', '-', '@']);
        let mark = if is_formula { "'" } else { "" };
        format!("\"{mark}{}\"", text.replace('"', "\"\""))
    };
    let row = |o: &Outcome| {
        let fields = [&*graded.name, o.exercise.stage, o.exercise.name].map(field);
        let (fields, message) = (fields.join(","), field(&o.message));
        format!("{fields},{},1,{message}\r\n", o.points)
    };
    results(graded, "", row).1
}

/// `JUnit` XML, in the elements that all its readers know: a suite for each submission.
fn junit(graded: &Graded) -> String {
    let (points, cases) = results(graded, "", |o| {
        let (e, message) = (o.exercise, xml(&o.message));
        let case = format!("<testcase classname={:?} name={:?}", e.stage, e.name);
        if o.points == 1 {
            return format!("{case}/>\n");
        }
        let first = xml(o.message.lines().next().unwrap_or_default());
        format!("{case}><failure message=\"{first}\">{message}</failure></testcase>\n")
    });
    let (name, all) = (xml(&graded.name), graded.results.len());
    let failures = all - points;
    format!(
        "<testsuite name=\"{name}\" tests=\"{all}\" failures=\"{failures}\" errors=\"0\">\n{cases}</testsuite>\n"
    )
}

/// A text for XML, without the control characters that it cannot express.
fn xml(text: &str) -> String {
    let text = text.replace(|c: char| c.is_control() && c != '\n', " ");
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('>', "&gt;").replace('"', "&quot;")
}

/// A text for JSON, in quotes.
fn json(text: &str) -> String {
    let escaped = |c: char| match c {
        '"' | '\\' => format!("\\{c}"),
        c if c.is_control() => format!("\\u{:04x}", c as u32),
        c => c.to_string(),
    };
    let text: String = text.chars().map(escaped).collect();
    format!("\"{text}\"")
}

/// Gradescope's `results.json`: <https://gradescope-autograders.readthedocs.io/en/latest/specs/>.
fn gradescope(graded: &Graded) -> String {
    let (points, tests) = results(graded, ",\n", |o| {
        let status = ["failed", "passed"][o.points];
        let (title, points, message) = (json(o.exercise.title), o.points, json(&o.message));
        format!(
            r#"{{"name": {title}, "score": {points}, "max_score": 1, "status": "{status}",
"output": {message}, "output_format": "text"}}"#
        )
    });
    format!("{{\"score\": {points}, \"visibility\": \"visible\", \"tests\": [\n{tests}\n]}}\n")
}

/// Fields of Classroom 50, and the variables that hold them.
#[rustfmt::skip]
const VARIABLES: [(&str, &str); 7] = [
    ("classroom", "CLASSROOM"), ("assignment", "ASSIGNMENT"), ("submission", "SUBMISSION_TAG"),
    ("commit", "COMMIT_URL"), ("release", "RELEASE_URL"), ("review", "REVIEW_URL"),
    ("datetime", "SUBMISSION_DATETIME"),
];

/// Classroom 50's `result.json`, for which its runner sets the variables:
/// <https://github.com/foundation50/classroom50/wiki/Advanced-Autograding>.
fn classroom50(graded: &Graded) -> String {
    let (points, tests) = results(graded, ",\n", |o| {
        let (name, points, message) = (o.exercise.name, o.points, json(&o.message));
        let passed = points == 1;
        format!(
            r#"{{"test-name": "{name}", "passed": {passed}, "score": {points}, "max-score": 1, "message": {message}}}"#
        )
    });
    let field = |(name, variable): &(&str, &str)| {
        let value = json(&env::var(variable).unwrap_or_default());
        format!("\"{name}\": {value},\n")
    };
    let fields: String = VARIABLES.iter().map(field).collect();
    let all = graded.results.len();
    format!(
        r#"{{"schema": "classroom50/result/v1", {fields}"score": {points}, "max-score": {all}, "tests": [
{tests}
]}}
"#
    )
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
        let outcome = |(exercise, message): (_, &str)| Outcome {
            exercise,
            points: usize::from(message == "right"),
            message: message.to_owned(),
        };
        let wrong = "a < b & \"c\"\nsecond line, \u{e4}";
        let graded = [Graded {
            name: "=ada".to_owned(),
            results: course.iter().zip(["right", wrong]).map(outcome).collect(),
        }];
        let mut python = Command::new("python3");
        python.args(["-c", READER]);
        let texts = FORMATS.map(|format| text(format, &graded));
        match python.args(texts).status() {
            Ok(status) => assert!(status.success()),
            Err(_) => eprintln!("skipped: without python3 nobody reads the results"),
        }
    }
}
