//! Judges the answers of libraries in `results/`: `cargo run -p corpus` prints the table of the book, and
//! `cargo run -p corpus -- NAME` each answer of one library that is not right.

use std::fmt::Write;
use std::process::ExitCode;
use std::{env, fs};

use corpus::{Answer, results, table};

fn main() -> ExitCode {
    match run() {
        Ok(text) => {
            print!("{text}");
            ExitCode::SUCCESS
        }
        Err(problem) => {
            eprintln!("corpus: {problem}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<String, String> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/results");
    let Some(name) = env::args().nth(1) else {
        let read = |name: &str| fs::read_to_string(format!("{folder}/{name}.txt")).ok();
        return table(read).map_err(|error| error.to_string());
    };
    let path = format!("{folder}/{name}.txt");
    let text = fs::read_to_string(&path).map_err(|error| format!("{path}: {error}"))?;
    let mut wrong = String::new();
    for judged in results::judged(&text).map_err(|error| format!("{path}: {error}"))? {
        if !judged.verdict.is_right() {
            let exact = match &judged.case.answer {
                Answer::Hit(hit) => hit.digits.as_str(),
                Answer::Miss => "miss",
                Answer::Coplanar => "coplanar",
            };
            let found = judged.found.map_or("miss".to_owned(), |t| format!("{t:?}"));
            let question = &judged.case.question;
            let is_decision = judged.verdict.decision == Some(false);
            let part = if is_decision { "decision" } else { "value" };
            // A `String` takes all.
            let _ = writeln!(
                wrong,
                "{}: {}\n    wrong {part}: found {found}, exact {exact}, condition {:?}, {}",
                question.id, question.says, judged.case.condition, question.source,
            );
        }
    }
    Ok(wrong)
}
