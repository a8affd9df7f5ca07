//! `grade`: judges the files of students in a handout without solutions.
//!
//! The student's program runs in a sandbox, and prints its answers. Another program, which has
//! the solution and nothing of the student, compares them: so an exit code is no verdict.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::Command;

use super::handout::Handout;
use super::refusal::refusal;
use super::result_file::{self, FORMATS};
use super::sandbox::{NOTE, Sandbox};
use super::{exercises, stages, submission};
use crate::exercise::{self, Exercise};
use crate::files::{self, failed};
use crate::judgement;

/// The most characters of a message.
const MESSAGE: usize = 2000;

/// A submission and its results, in the order of the exercises.
pub struct Graded {
    pub name: String,
    pub results: Vec<Outcome>,
}

/// The result of an exercise.
pub struct Outcome {
    pub exercise: &'static Exercise,
    /// 1 if it is right, and else 0.
    pub points: usize,
    /// The message to the student.
    pub message: String,
}

/// For lecturers: judges submissions, with limits
#[derive(clap::Args)]
pub struct Grade {
    /// Submissions
    #[arg(required = true, value_name = "FOLDER_OR_ZIP")]
    paths: Vec<PathBuf>,
    /// The last stage, as a04 [default: all stages]
    #[arg(long, value_name = "STAGE")]
    until: Option<String>,
    /// The exercises that count [default: all of the stages]
    #[arg(long, value_name = "NAME,NAME", value_delimiter = ',', value_parser = exercise::find)]
    exercises: Vec<&'static Exercise>,
    /// The form of the results
    #[arg(long, default_value = "table", value_parser = FORMATS)]
    format: String,
}

impl Grade {
    pub fn run(self, course: &'static [Exercise]) -> Result<String, String> {
        let all = exercises(course, self.until.as_ref())?;
        let named = &self.exercises;
        let chosen = if named.is_empty() { &all } else { named };
        if let Some(e) = chosen.iter().find(|e| !all.contains(e)) {
            return Err(format!("{} belongs to a later stage", e.name));
        }
        let format = &*self.format;
        if ["gradescope", "classroom50"].contains(&format) && self.paths.len() > 1 {
            return Err(format!("a file for {format} is about one submission"));
        }
        if let Some(path) = self.paths.iter().find(|path| !path.exists()) {
            return Err(format!(
                "{}: there is no such folder or file",
                path.display()
            ));
        }
        let sandbox = prepared(&all)?;
        let grade = |path: &PathBuf| {
            let name = path.file_stem().unwrap_or(path.as_os_str());
            let name = name.to_string_lossy().into_owned();
            eprintln!("{name}");
            let results = chosen.iter().map(|e| outcome(&sandbox, e, path)).collect();
            Graded { name, results }
        };
        let graded: Vec<_> = self.paths.iter().map(grade).collect();
        Ok(result_file::text(format, &graded))
    }
}

/// A sandbox with a handout without solutions, which is built.
fn prepared(all: &[&Exercise]) -> Result<Sandbox, String> {
    let folder = files::workspace().join("target/grading");
    let workbook = folder.join("workbook");
    // If it remains, it is no new folder for a handout.
    let _ = fs::remove_dir_all(&workbook);
    let handout = Handout {
        folder: workbook,
        without_solutions: true,
        ..Handout::default()
    };
    handout.write(all)?;
    let target = folder.join("target");
    fs::create_dir_all(&target).map_err(failed(&target))?;
    let sandbox = Sandbox { folder };
    let has_own_root = sandbox.run("check", "", &["test", "-d", "/course"], "");
    if has_own_root.is_err() {
        eprintln!("{NOTE}");
    }
    let build = "cargo test --offline --quiet --no-run --test exercises";
    let mut build: Vec<_> = build.split(' ').collect();
    build.extend(stages(all).into_iter().flat_map(|stage| ["-p", stage]));
    sandbox.run("all", "", &build, "the handout does not build")?;
    Ok(sandbox)
}

/// Judges a file of a submission. Each error is a result, so that no submission ends the
/// grading of others.
fn outcome(sandbox: &Sandbox, exercise: &'static Exercise, path: &Path) -> Outcome {
    let verdict = submission::read(path, exercise);
    let verdict = verdict.and_then(|text| judge(sandbox, exercise, &text));
    let points = usize::from(verdict.is_ok());
    let message = verdict.err().unwrap_or_else(|| "right".to_owned());
    Outcome {
        exercise,
        points,
        message: message.chars().take(MESSAGE).collect(),
    }
}

/// Builds and runs a file, and compares its answers.
fn judge(sandbox: &Sandbox, e: &Exercise, text: &str) -> Result<(), String> {
    refusal(e, text).map_or(Ok(()), Err)?;
    let file = sandbox.folder.join("workbook").join(e.stage);
    let file = file.join("exercises").join(e.name).with_extension("rs");
    fs::write(&file, text).map_err(failed(&file))?;
    let words = judgement::arguments(e);
    let mut build = vec!["cargo", "--offline", "--quiet"];
    build.extend(words.iter().map(String::as_str));
    let built = sandbox.run("build", "", &build, "does not compile");
    // The next submission shall not find it.
    fs::remove_file(&file).map_err(failed(&file))?;
    let program = judgement::program(&built?)?;
    sandbox.run("check", e.name, &[&program], "not yet")?;

    let answers = sandbox.output();
    let answers = File::open(&answers).map_err(failed(&answers))?;
    let proofs = judgement::proofs(e.stage)?;
    let mut verdict = Command::new(&proofs);
    verdict.env("EXERCISE_JUDGED", e.name).stdin(answers);
    let verdict = verdict.output().map_err(failed(proofs.as_ref()))?;
    let wrong = String::from_utf8_lossy(&verdict.stdout);
    let wrong = wrong.trim_end();
    let forged = || format!("the program reports success, but its answers say: {wrong}");
    verdict.status.success().then_some(()).ok_or_else(forged)
}
