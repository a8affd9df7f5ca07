//! `grade`: judges the files of students in a handout without solutions.
//!
//! The student's program runs in a sandbox, and prints its answers. Another program, which has
//! the solution and nothing of the student, compares them: so an exit code is no verdict.

use std::fs::{self, File};
use std::path::Path;
use std::process::Command as Process;
use std::time::Instant;

use clap::{Arg, ArgMatches, Command};

use super::refusal::refusal;
use super::result_file::{self, FORMATS};
use super::sandbox::{NOTE, Sandbox};
use super::{exercises, failed, handout, stages, submission, until};
use crate::exercise::Exercise;
use crate::{files, judgement};

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
    pub is_right: bool,
    /// The message to the student.
    pub message: String,
    pub seconds: f64,
}

pub fn command() -> Command {
    let paths = Arg::new("paths").value_name("FOLDER_OR_ZIP");
    let names = Arg::new("exercises").long("exercises");
    let names = names.value_name("NAME,NAME").value_delimiter(',');
    let format = Arg::new("format").long("format").default_value("table");
    let output = Arg::new("output").short('o').long("output");
    Command::new("grade")
        .about("For lecturers: judges submissions, with limits")
        .arg(paths.num_args(1..).required(true).help("Submissions"))
        .arg(until())
        .arg(names.help("The exercises that count [default: all of the stages]"))
        .arg(format.value_parser(FORMATS).help("The form of the results"))
        .arg(
            output
                .value_name("FILE")
                .help("The file of the results [default: standard output]"),
        )
}

pub fn run(course: &'static [Exercise], matches: &ArgMatches) -> Result<String, String> {
    let all = exercises(course, matches)?;
    let names = matches.get_many::<String>("exercises");
    let find = |name: &String| {
        let exercise = all.iter().copied().find(|e| e.name == name);
        exercise.ok_or_else(|| format!("no exercise of these stages is {name}"))
    };
    let chosen = names.map_or(Ok(all.clone()), |names| names.map(find).collect())?;
    let format = matches.get_one::<String>("format");
    let format = format.map_or("", |format| format);
    let paths = matches.get_many::<String>("paths");
    let paths: Vec<_> = paths.into_iter().flatten().collect();
    if ["gradescope", "classroom50"].contains(&format) && paths.len() > 1 {
        return Err(format!("a file for {format} is about one submission"));
    }
    if let Some(path) = paths.iter().find(|path| !Path::new(path).exists()) {
        return Err(format!("{path}: there is no such folder or file"));
    }
    let sandbox = prepared(&all)?;
    let grade = |path: &String| {
        let path = Path::new(path);
        let name = path.file_stem().unwrap_or(path.as_os_str());
        let name = name.to_string_lossy().into_owned();
        eprintln!("{name}");
        let results = chosen.iter().map(|e| outcome(&sandbox, e, path)).collect();
        Graded { name, results }
    };
    let graded: Vec<_> = paths.into_iter().map(grade).collect();
    let text = result_file::text(format, &graded);
    let Some(file) = matches.get_one::<String>("output") else {
        return Ok(text);
    };
    fs::write(file, text).map_err(failed(file.as_ref()))?;
    Ok(format!("{file}: {} submissions", graded.len()))
}

/// A sandbox with a handout without solutions, which is built.
fn prepared(all: &[&Exercise]) -> Result<Sandbox, String> {
    let folder = files::workspace().join("target/grading");
    let workbook = folder.join("workbook");
    if workbook.exists() {
        fs::remove_dir_all(&workbook).map_err(failed(&workbook))?;
    }
    handout::write(&workbook, all, true)?;
    let target = folder.join("target");
    fs::create_dir_all(&target).map_err(failed(&target))?;
    let sandbox = Sandbox { folder };
    if sandbox
        .run("check", "", &["test", "-d", "/course"], "")
        .is_err()
    {
        eprintln!("{NOTE}");
    }
    let build = "cargo test --offline --quiet --no-run --test exercises";
    let packages = stages(all)
        .into_iter()
        .flat_map(|stage| ["--package", stage]);
    let build: Vec<_> = build.split(' ').chain(packages).collect();
    sandbox.run("all", "", &build, "the handout does not build")?;
    Ok(sandbox)
}

/// Judges a file of a submission. Each error is a result, so that no submission ends the
/// grading of others.
fn outcome(sandbox: &Sandbox, exercise: &'static Exercise, path: &Path) -> Outcome {
    let start = Instant::now();
    let verdict = submission::read(path, exercise);
    let verdict = verdict.and_then(|text| judge(sandbox, exercise, &text));
    let message = verdict.clone().err().unwrap_or_else(|| "right".to_owned());
    Outcome {
        exercise,
        is_right: verdict.is_ok(),
        message: message.chars().take(MESSAGE).collect(),
        seconds: start.elapsed().as_secs_f64(),
    }
}

/// Builds and runs a file, and compares its answers.
fn judge(sandbox: &Sandbox, e: &Exercise, text: &str) -> Result<(), String> {
    refusal(e, text).map_or(Ok(()), Err)?;
    let file = sandbox.folder.join("workbook").join(e.stage);
    let file = file.join("exercises").join(e.name).with_extension("rs");
    fs::write(&file, text).map_err(failed(&file))?;
    let words = judgement::arguments(e);
    let words = words.iter().map(String::as_str);
    let build: Vec<_> = ["cargo", "--offline", "--quiet"]
        .into_iter()
        .chain(words)
        .collect();
    let built = sandbox.run("build", "", &build, "does not compile");
    // The next submission shall not find it.
    fs::remove_file(&file).map_err(failed(&file))?;
    let program = judgement::program(&built?)?;
    sandbox.run("check", e.name, &[&program], "not yet")?;

    let answers = sandbox.output();
    let answers = File::open(&answers).map_err(failed(&answers))?;
    let proofs = judgement::proofs(e.stage)?;
    let mut verdict = Process::new(&proofs);
    verdict.env("EXERCISE_JUDGED", e.name).stdin(answers);
    let verdict = verdict.output().map_err(failed(proofs.as_ref()))?;
    let wrong = String::from_utf8_lossy(&verdict.stdout);
    let forged = || format!("the program reports success, but its answers say: {wrong}");
    verdict.status.success().then_some(()).ok_or_else(forged)
}
