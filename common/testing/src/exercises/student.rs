//! `judge`: shows students the faults of their code.

use std::collections::BTreeSet;
use std::env;
use std::panic::{self, Location, PanicHookInfo};
use std::process::ExitCode;
use std::sync::Mutex;

use exercise::StudentOutput;

use super::Missing;
use super::assertion::{assertion_words, is_rounding};
use super::exercise::Exercise;
use super::folder::StageFolder;
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
    // A starter's examples fail, and nothing is wrong yet.
    let is_begun = folder.is_begun(name);
    let lines = Mutex::new(BTreeSet::new());
    panic::set_hook(Box::new(move |panic| {
        if panic.payload_as_str().is_some_and(is_rounding) {
            return;
        }
        let line = panic.location().map_or(0, Location::line);
        // A line may panic for each input, and in each row of a picture.
        if is_begun && lines.lock().is_ok_and(|mut lines| lines.insert(line)) {
            say(&panic_words(name, panic));
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
    let program = Program::new(exercise, yours.clone());
    let reader = if is_printed {
        Reader::Grader
    } else {
        Reader::Student
    };
    let found = program.run(examples, &record, folder, reader);
    // A grader sees no picture.
    let shown = found.drawing.as_ref().or(found.image.as_ref());
    if let Some(image) = shown.filter(|_| !is_printed) {
        say(&folder.save(image, &format!("{}-{name}.png", folder.stage().name)));
    }
    if !found.missing.is_empty() {
        for Missing { what, line } in &found.missing {
            say(&format!(
                "to do: {what}\n    in {name}.rs, line {line}, instead of `testing::missing(…)`"
            ));
        }
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

/// The words about a panic of a student's code, which may happen in a library.
fn panic_words(name: &str, panic: &PanicHookInfo) -> String {
    let message = panic.payload_as_str().unwrap_or_default();
    let own_file = format!("{name}.rs");
    let (file, line) = match panic.location() {
        Some(location) if !location.file().ends_with(&own_file) => {
            (location.file(), location.line())
        }
        location => (&*own_file, location.map_or(0, Location::line)),
    };
    format!("{file}, line {line}: {}", assertion_words(message))
}
