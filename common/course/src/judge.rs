//! `judge`: compiles a student's file, runs its program, and compares its answers.
//!
//! The program prints its answers. The grader compares them with the recorded ones of its own
//! workbook: so an exit code is no verdict.

use exercise::{Record, Verdict, read_answers, verdict};
use learn::exercise::Exercise;
use learn::files;

use crate::grading_folder::GradingFolder;
use crate::outcome::{Outcome, State};
use crate::refusal::refusal;
use crate::sandbox::{End, Limits, Place};

/// Judges the text of a student's file. Faults of the grader end no grading: the file needs a look.
pub fn judge(folder: &GradingFolder, e: &'static Exercise, text: &str) -> Outcome {
    judged(folder, e, text).unwrap_or_else(|fault| {
        eprintln!("{}: the grader fails: {fault}", e.name);
        Outcome::without_answers(State::NeedsALook, "the grader could not judge it")
    })
}

/// The outcome, or a fault of the grader.
fn judged(folder: &GradingFolder, e: &'static Exercise, text: &str) -> Result<Outcome, String> {
    let wrong = |message: &str| Outcome::without_answers(State::Wrong, message);
    if let Some(refused) = refusal(e, text) {
        // Words are a hint, and no proof: a person decides.
        return Ok(Outcome::without_answers(State::NeedsALook, &refused));
    }
    let _lock = folder.lock()?;
    let sandbox = &folder.sandbox;
    let built = folder.build(e, text, Limits::Build)?;
    match built.end {
        End::Success => {}
        // It says nothing about the file: the computer may have been busy.
        End::Limit(_) => {
            let why = sandbox.words(&built, "does not compile");
            return Ok(Outcome::without_answers(
                State::NeedsALook,
                &format!("while it was compiled: {why}"),
            ));
        }
        // Cargo ends by itself where the system has ended the compiler, such as for want of memory.
        _ if built.output.contains("(signal: ") => {
            return Ok(Outcome::without_answers(
                State::NeedsALook,
                "while it was compiled: the compiler was stopped",
            ));
        }
        // Nor does a file, where the check is at fault.
        _ if folder.fault(e)?.is_some() => {
            return Ok(Outcome::without_answers(
                State::NeedsALook,
                "the workbook is at fault: the starter of this exercise does not compile",
            ));
        }
        _ => {
            let words = learn::lacks(&built.output);
            let words = words.unwrap_or_else(|| sandbox.words(&built, "does not compile"));
            return Ok(wrong(&words));
        }
    }
    let program = learn::find_program(&built.output, "test")?;
    let ended = sandbox.run(Limits::Check, Place::Workbook, [program])?;
    let message = sandbox.words(&ended, "not yet");
    let file = format!("{}/exercises/answers/{}.txt", e.stage, e.name);
    let record = Record::read(&files::read(&file)?)?;
    let answers = read_answers(&ended.output);
    let found = verdict(&record, &answers);
    match ended.end {
        End::Success if found.wrong.is_empty() => Ok(Outcome::right()),
        End::Success => {
            let wrong = found.wrong.join("\n");
            let message = format!("the program reports success, but its answers say: {wrong}");
            Ok(wrong_answers(message, found))
        }
        End::Failure if !answers.is_empty() => Ok(wrong_answers(message, found)),
        _ => Ok(wrong(&message)),
    }
}

/// The outcome of a program that says it is wrong, or whose answers say so.
fn wrong_answers(message: String, found: Verdict) -> Outcome {
    // If all answers are right, something else is wrong.
    let (compared, differ) = match found.differ {
        0 => (found.compared + 1, 1),
        differ => (found.compared, differ),
    };
    let mistake = match found.known {
        Some(known) => known.replace("this is a known mistake; it ", ""),
        None => match found.wrong.into_iter().next() {
            Some(wrong) => wrong,
            None => "the picture, or an example at the end of the file".to_owned(),
        },
    };
    Outcome {
        state: State::Wrong,
        message,
        fraction: (compared - differ) as f64 / compared as f64,
        mistake: mistake.lines().next().unwrap_or_default().to_owned(),
    }
}
