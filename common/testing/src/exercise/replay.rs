//! Checks without the solution, and verdicts without the student's code, by [`Tape`]s.
//!
//! A handout has the answers of its solutions in `exercises/recorded/NAME`. A grader lets the
//! student's program print its answers, and compares them here, in another process.

use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

use super::findings::Findings;
use super::picture::ROOT;
use super::tape::Tape;
use super::{Check, Code, Exercise};

/// The environment names an exercise whose answers are printed by the solution, or one whose
/// answers at the standard input are judged. A student's program prints those of its only exercise.
const PRINTED: &str = "EXERCISE_PRINTED";
const JUDGED: &str = "EXERCISE_JUDGED";

/// The recorded answers of an exercise, which has them where its solution is not handed out.
pub fn recorded(stage: &str, name: &str) -> PathBuf {
    let folder = Path::new(ROOT).join(stage).join("exercises/recorded");
    folder.join(name)
}

impl Check {
    /// A check of the student's code.
    pub(super) fn of_yours(stage: &str, name: &str) -> Self {
        let mut check = Self::new(true, None);
        check.is_yours = true;
        if let Ok(record) = fs::read_to_string(recorded(stage, name)) {
            check.lesson = Tape::read(&record);
        }
        if env::var_os(PRINTED).is_some() {
            check.yours = Tape::Kept(Vec::new());
        }
        check
    }
}

/// Prints or judges answers, if the environment says so.
pub fn replay(exercises: &[Exercise]) -> Option<ExitCode> {
    let find = |variable| {
        let name = env::var(variable).ok()?;
        exercises.iter().find(|e| e.name == name)
    };
    let mut check = Check::default();
    if let Some(exercise) = find(PRINTED) {
        check.lesson = Tape::Kept(Vec::new());
        (exercise.solution.check)(&mut check);
        check.lesson.print();
        return Some(ExitCode::SUCCESS);
    }
    // The solution stands in the place of the student's code, and its answers are not used.
    let code = Code {
        examples: || (),
        ..find(JUDGED)?.solution
    };
    let mut answers = Vec::new();
    // Those that cannot be read are missing.
    let _ = io::stdin().read_to_end(&mut answers);
    check.yours = Tape::read(&String::from_utf8_lossy(&answers));
    let wrong = Findings::of(code, check).wrong;
    println!("{}", wrong.join("\n"));
    Some(ExitCode::from(u8::from(!wrong.is_empty())))
}
