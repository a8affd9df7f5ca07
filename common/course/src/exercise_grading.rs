//! `exercise_grading`: compiles a student's files, runs their program, and compares its answers.
//!
//! The program prints its answers. The grader compares them with the recorded ones of its own
//! workbook, which the program cannot read: so an exit code is no verdict.

use std::collections::BTreeMap;
use std::ffi::OsStr;

use judge::answers::{StudentAnswer, Verdict, read_answers, verdict};
use learn::exercise::Exercise;
use learn::refusal;

use crate::exercise_record::record;
use crate::grading_folder::GradingFolder;
use crate::outcome::{Outcome, State};
use crate::sandbox::{End, Ended, Limits, Place};
use crate::submission::StudentFile;

/// The outcomes of files of one student for exercises of one stage, by their names. Faults of the grader end no grading: the file needs a look.
pub fn outcomes(folder: &GradingFolder, files: &[StudentFile]) -> BTreeMap<&'static str, Outcome> {
    // A fault shows again where a file is built by itself.
    let mut together = run_together(folder, files).unwrap_or_default();
    let mut outcomes = BTreeMap::new();
    for file in files {
        let e = file.exercise;
        let ended = match together.remove(e.name) {
            Some(ended) => Ok(Ok(ended)),
            None => run(folder, *file, &[]),
        };
        let judged = ended.and_then(|ended| match ended {
            Ok(ended) => judge_answers(folder, e, &ended),
            Err(outcome) => Ok(outcome),
        });
        let outcome = judged.unwrap_or_else(|fault| {
            eprintln!("{}: the grader fails: {fault}", e.name);
            Outcome::without_answers(State::NeedsALook, "the grader could not judge it")
        });
        outcomes.insert(e.name, outcome);
    }
    outcomes
}

/// Compiles all files that count into one program, which takes less time, and runs it for each. Empty if they do not
/// compile together: then each is built by itself, which says what is wrong with it.
///
/// A file may do something to the others in its program. They are the same student's, who could
/// have written the same into them; and no program finds that of another student.
fn run_together(
    folder: &GradingFolder,
    files: &[StudentFile],
) -> Result<BTreeMap<&'static str, Ended>, String> {
    let mut all = BTreeMap::new();
    let mut files = files.to_vec();
    files.retain(|file| refusal(file.exercise, file.text).is_none());
    if files.len() < 2 {
        return Ok(all);
    }
    let _lock = folder.lock()?;
    let built = folder.build(&files, Limits::Build)?;
    if built.end == End::Success {
        for file in files {
            let ended = run_program(folder, file.exercise, &built, &[])?;
            all.insert(file.exercise.name, ended);
        }
    }
    Ok(all)
}

/// The outcome of a program that has ended, or a fault of the grader.
fn judge_answers(
    folder: &GradingFolder,
    e: &'static Exercise,
    ended: &Ended,
) -> Result<Outcome, String> {
    let message = folder.sandbox.words(ended, "not yet");
    let record = record(e)?;
    let (answers, painted) = read_answers(&ended.output);
    let mut found = verdict(&record, &answers);
    if let Some(painted) = &painted {
        found.add_picture(painted);
    }
    let has_ended = ended.end == End::Success || (ended.end == End::Failure && !answers.is_empty());
    if !has_ended {
        return Ok(Outcome::without_answers(State::Wrong, &message));
    }
    if ended.end == End::Success && found.wrong.is_empty() {
        return Ok(Outcome::right());
    }
    let words = [&[message][..], &found.wrong, found.known.as_slice()].concat();
    let message = folder.sandbox.without_place(&words.join("\n"));
    Ok(wrong_answers(message, found, answers))
}

/// Compiles a student's file, and runs its program by the words of another one, if there are any; or the outcome
/// of a file that has no program. The error is a fault of the grader.
pub fn run(
    folder: &GradingFolder,
    file: StudentFile,
    by: &[&OsStr],
) -> Result<Result<Ended, Outcome>, String> {
    let StudentFile { exercise: e, text } = file;
    let without_answers = |state, message: &str| Ok(Err(Outcome::without_answers(state, message)));
    if let Some(refused) = refusal(e, text) {
        // Words are a hint, and no proof: a person decides.
        return without_answers(State::NeedsALook, &refused);
    }
    let _lock = folder.lock()?;
    let sandbox = &folder.sandbox;
    let built = folder.build(&[file], Limits::Build)?;
    match built.end {
        End::Success => {}
        // It says nothing about the file: the computer may have been busy.
        End::Limit(_) => {
            let why = sandbox.words(&built, "does not compile");
            let message = format!("while it was compiled: {why}");
            return without_answers(State::NeedsALook, &message);
        }
        // Cargo ends by itself where the system has ended the compiler, such as for want of memory.
        _ if built.output.contains("(signal: ") => {
            let message = "while it was compiled: the compiler was stopped";
            return without_answers(State::NeedsALook, message);
        }
        // Nor does a file, where the check is at fault.
        _ if folder.fault(e)?.is_some() => {
            let message = "the workbook is at fault: the starter of this exercise does not compile";
            return without_answers(State::NeedsALook, message);
        }
        _ => {
            let lacks = learn::lacks(e, text);
            let message = lacks.unwrap_or_else(|| sandbox.words(&built, "does not compile"));
            return without_answers(State::Wrong, &message);
        }
    }
    run_program(folder, e, &built, by).map(Ok)
}

/// Runs the program that was built for this exercise.
fn run_program(
    folder: &GradingFolder,
    e: &Exercise,
    built: &Ended,
    by: &[&OsStr],
) -> Result<Ended, String> {
    let program = learn::find_program(&built.output, learn::Kind::Test)?;
    let words = by
        .iter()
        .copied()
        .chain([program.as_ref(), e.name.as_ref()]);
    folder.sandbox.run(Limits::Check, Place::Workbook, words)
}

/// The outcome of a program whose answers are wrong, or that says that something else is.
fn wrong_answers(message: String, found: Verdict, answers: Vec<StudentAnswer>) -> Outcome {
    // If all answers are right, something else is wrong.
    let (compared, differ) = match found.differ {
        0 => (found.compared + 1, 1),
        differ => (found.compared, differ),
    };
    let is_unnamed = found.differ > 0 && found.known.is_none();
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
        pictures: Vec::new(),
        unnamed: if is_unnamed { answers } else { Vec::new() },
    }
}
