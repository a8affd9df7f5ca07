//! `judge`: shows students the faults of their code.

use std::collections::BTreeSet;
use std::env;
use std::panic::{self, Location, PanicHookInfo};
use std::process::ExitCode;
use std::sync::Mutex;

use exercise::StudentOutput;

use super::Missing;
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
    // A starter's examples fail, and nothing is wrong yet.
    let is_begun = folder.is_begun(name);
    let lines = Mutex::new(BTreeSet::new());
    panic::set_hook(Box::new(move |panic| {
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
    let program = Program::new(exercise, yours.clone(), &record.found);
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

/// The message of a panic; that of `assert_eq!(yours, right)` in the words of the checks.
fn assertion_words(message: &str) -> String {
    let equal = message.strip_prefix("assertion `left == right` failed");
    let parts = equal.and_then(|rest| {
        let (about, values) = rest.split_once("\n  left: ")?;
        let (yours, right) = values.split_once("\n right: ")?;
        Some([about, yours, right])
    });
    let Some([about, yours, right]) = parts else {
        return message.to_owned();
    };
    let about = match about.strip_prefix(": ") {
        Some(about) => format!("{about}:"),
        None => "an example fails:".to_owned(),
    };
    format!("{about}\n    must be {right}; yours is {yours}")
}

#[cfg(test)]
mod tests {
    use std::panic::catch_unwind;

    use super::*;

    /// The message of the standard library for these values.
    fn message_of(assertion: fn()) -> String {
        let payload = catch_unwind(assertion).unwrap_err();
        match payload.downcast::<String>() {
            Ok(message) => *message,
            Err(payload) => (*payload.downcast_ref::<&str>().unwrap()).to_owned(),
        }
    }

    #[test]
    fn values_of_an_assertion_are_yours_and_the_right_one() {
        let words = |assertion| assertion_words(&message_of(assertion));
        assert_eq!(
            words(|| assert_eq!(1 + 1, 3, "the sum of {} numbers", 2)),
            "the sum of 2 numbers:\n    must be 3; yours is 2"
        );
        assert_eq!(
            words(|| assert_eq!([1], [2])),
            "an example fails:\n    must be [2]; yours is [1]"
        );
        assert_eq!(words(|| panic!("left == {}", 1)), "left == 1");
    }
}
