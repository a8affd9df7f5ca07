//! `judge`: shows students the faults of their code.

use std::collections::BTreeSet;
use std::env;
use std::panic::{self, Location};
use std::process::ExitCode;
use std::sync::Mutex;

use exercise::StudentOutput;

use super::folder::StageFolder;
use super::kind::Exercise;
use super::program::{Program, Reader};
use super::say::{remark, say};

/// With this variable in the environment, the program prints its answers and its picture for a
/// grader.
const PRINTED: &str = "EXERCISE_PRINTED";

/// Runs the examples of a student's file, asks its code, prints the findings, and exits with
/// 0 if the code is right, with 1 if it is not, and with 3 if parts are still missing.
#[must_use]
pub fn judge<C: Clone + 'static>(
    folder: &StageFolder,
    name: &'static str,
    exercise: Exercise<C>,
    yours: C,
    examples: fn(),
) -> ExitCode {
    let lines = Mutex::new(BTreeSet::new());
    panic::set_hook(Box::new(move |panic| {
        let line = panic.location().map_or(0, Location::line);
        // A line may panic for each input, and in each row of a picture.
        if lines.lock().is_ok_and(|mut lines| lines.insert(line)) {
            let message = panic.payload_as_str().unwrap_or_default();
            say(&format!("{name}.rs, line {line}: {message}"));
        }
    }));
    let record = match folder.record(name) {
        Ok(record) => record,
        Err(problem) => {
            say(&problem);
            return ExitCode::FAILURE;
        }
    };
    let is_printed = env::var_os(PRINTED).is_some();
    let exercise_remark = exercise.remark;
    let program = Program::new(exercise, yours.clone(), &record.found);
    let reader = if is_printed {
        Reader::Grader
    } else {
        Reader::Student
    };
    let found = program.run(examples, &record, folder, reader);
    // A grader sees no picture.
    if let Some(image) = found.image.as_ref().filter(|_| !is_printed) {
        say(&folder.save(image, &format!("{}-{name}.png", folder.stage().name)));
    }
    if !found.missing.is_empty() {
        say(&format!("to do: {}", found.missing.join("; ")));
        return ExitCode::from(3);
    }
    let is_right = found.verdict.wrong.is_empty();
    for words in &found.verdict.wrong {
        say(words);
    }
    if let Some(note) = &found.verdict.note {
        remark(note);
    }
    if let Some(about_right) = exercise_remark.filter(|_| is_right) {
        remark(&about_right(&yours).unwrap_or_else(|error| error.to_string()));
    }
    if let Some(words) = &found.verdict.known {
        say(words);
    }
    if is_printed {
        let picture = found.image.filter(|_| record.picture.is_some());
        let answers = found.given;
        print!("{}", StudentOutput { answers, picture });
    }
    ExitCode::from(u8::from(!is_right))
}
