//! `judge`: shows students the faults of their code.

use std::collections::BTreeSet;
use std::panic::{self, Location};
use std::process::ExitCode;
use std::sync::Mutex;

use super::findings::Findings;
use super::known::recognised;
use super::tape::Tape;
use super::{Check, Code, Mistakes, picture, replay};

/// Runs the examples and the check of a student's file, prints the findings, and exits with
/// 0 if the code is right, with 1 if it is not, and with 3 if parts are still missing.
#[must_use]
pub fn judge(stage: &str, name: &'static str, code: Code, known: Mistakes) -> ExitCode {
    let lines = Mutex::new(BTreeSet::new());
    panic::set_hook(Box::new(move |panic| {
        let line = panic.location().map_or(0, Location::line);
        // A line may panic for each input, and in each row of a picture.
        if lines.lock().is_ok_and(|mut lines| lines.insert(line)) {
            let message = panic.payload_as_str().unwrap_or_default();
            println!("{name}.rs, line {line}: {message}");
        }
    }));
    let found = Findings::of(code, Check::of_yours(stage, name));
    // A grader sees no picture.
    if let (Some(image), Tape::Computed) = (&found.check.picture, &found.check.yours) {
        picture::save(image, &format!("{stage}-{name}.png"));
    }
    if !found.missing.is_empty() {
        println!("to do: {}", found.missing.join("; "));
        return ExitCode::from(3);
    }
    // Without the solution, nothing is known about mistakes.
    let has_known = !found.wrong.is_empty() && !replay::recorded(stage, name).is_file();
    let known = has_known.then(|| recognised(&found.check, known)).flatten();
    for line in found.wrong.iter().chain(&found.check.note).chain(&known) {
        println!("{line}");
    }
    found.check.yours.print();
    ExitCode::from(u8::from(!found.wrong.is_empty()))
}
