//! `judge`: compiles a student's file, runs its program, and compares its answers.
//!
//! The program prints its answers and its picture. The grader compares them with the recorded ones
//! of its own workbook: so an exit code is no verdict.

use std::fs;

use ::exercise::{
    PictureVerdict, Record, StudentOutput, Verdict, expected_picture, pictured, verdict,
};

use super::grading_folder::GradingFolder;
use super::outcome::{Cause, Outcome, State};
use super::refusal::refusal;
use super::sandbox::{End, Limits};
use crate::build;
use crate::exercise::Exercise;
use crate::files::{self, with_path};
use crate::missing_name::find_missing_name;

/// Judges the text of a student's file. Faults of the grader end no grading: the file needs a look.
pub fn judge(folder: &GradingFolder, e: &Exercise, text: &str) -> Outcome {
    judged(folder, e, text).unwrap_or_else(|fault| {
        eprintln!("{}: the grader fails: {fault}", e.name);
        Outcome::needs_a_look("the grader could not judge it")
    })
}

/// The outcome, or a fault of the grader.
fn judged(folder: &GradingFolder, e: &Exercise, text: &str) -> Result<Outcome, String> {
    if let Some(refused) = refusal(e, text) {
        return Ok(Outcome::without_answers(refused));
    }
    if let Some(lacks) = find_missing_name(e, text) {
        let why = format!("does not compile: {lacks}");
        return Ok(Outcome::without_answers(why));
    }
    let sandbox = &folder.sandbox;
    let file = folder.in_workbook(&format!("{}/exercises/{}.rs", e.stage, e.name));
    fs::write(&file, text).map_err(with_path(&file))?;
    let mut build = ["cargo", "--offline", "--quiet"]
        .map(str::to_owned)
        .to_vec();
    build.extend(build::arguments(e));
    let built = sandbox.run(Limits::Build, build);
    // The next submission shall not find it.
    fs::remove_file(&file).map_err(with_path(&file))?;
    let built = built?;
    if built.end != End::Success {
        let why = sandbox.words(&built, "does not compile");
        return Ok(Outcome::without_answers(why));
    }
    let program = build::find_program(&built.output)?;
    let ended = sandbox.run(Limits::Check, [program])?;
    let record = record(e)?;
    let printed = StudentOutput::read(&ended.output);
    let found = compare(e, &record, &printed);
    match ended.end {
        End::Success if found.wrong.is_empty() => Ok(Outcome::right()),
        End::Success => {
            let wrong = found.wrong.join("\n");
            let message = format!("the program reports success, but its answers say: {wrong}");
            Ok(wrong_answers(message, found, printed))
        }
        End::Failure if !printed.answers.is_empty() => {
            let message = sandbox.words(&ended, "not yet");
            Ok(wrong_answers(message, found, printed))
        }
        _ => Ok(Outcome::without_answers(sandbox.words(&ended, "not yet"))),
    }
}

/// The recorded answers.
fn record(e: &Exercise) -> Result<Record, String> {
    let file = format!("{}/exercises/answers/{}.txt", e.stage, e.name);
    Record::read(&files::read(&file)?)
}

/// Compares the answers and the picture of a program with the recorded ones.
fn compare(e: &Exercise, record: &Record, printed: &StudentOutput) -> Verdict {
    let picture = record.picture.as_ref().map(|scene| {
        let expected = expected_picture(&files::workspace(), e.stage, scene);
        match &printed.picture {
            Some(image) => pictured(scene, &expected, image, None),
            None => PictureVerdict {
                name: format!("the picture of scene {scene}"),
                is_right: false,
                words: "it is missing".to_owned(),
                divergence: None,
            },
        }
    });
    verdict(record, &printed.answers, picture)
}

/// The outcome of a program that says it is wrong, or whose answers say so.
fn wrong_answers(message: String, found: Verdict, printed: StudentOutput) -> Outcome {
    // If all answers are right, an example at the end of the file is wrong.
    let (compared, differ) = match found.differ {
        0 => (found.compared + 1, 1),
        differ => (found.compared, differ),
    };
    let cause = match found.known {
        Some(known) => Cause::Known(known.replace("this is a known mistake; it ", "")),
        None => Cause::Answers {
            given: printed.answers,
            first: found.wrong.into_iter().next().unwrap_or_default(),
        },
    };
    Outcome {
        state: State::Wrong,
        message,
        fraction: (compared - differ) as f64 / compared as f64,
        cause: Some(cause),
    }
}
