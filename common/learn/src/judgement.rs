//! `judge`: builds the test program of a stage with a student's file, and runs it.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::exercise::{Exercise, ROOT};
use crate::progress;

/// The result of a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    Done,
    Wrong,
    ToDo,
    DoesNotCompile,
    Endless,
}

/// The longest time that a check may take.
const LONGEST: Duration = Duration::from_mins(1);

/// Checks a student's file, prints the findings and records the progress. A `loud` build
/// shows that it goes on.
pub fn judge(exercise: Exercise, loud: bool) -> Result<Verdict, String> {
    let verdict = match build(exercise, loud)? {
        Some(program) => run(&program)?,
        None => Verdict::DoesNotCompile,
    };
    match verdict {
        Verdict::Done => println!("{}: done", exercise.name),
        Verdict::Wrong => println!("{}: not yet", exercise.name),
        Verdict::ToDo => {}
        Verdict::DoesNotCompile => println!("{}: does not compile", exercise.name),
        Verdict::Endless => {
            let seconds = LONGEST.as_secs();
            println!("{}: no end after {seconds} seconds", exercise.name);
        }
    }
    if verdict == Verdict::Done {
        progress::record(exercise)?;
    }
    Ok(verdict)
}

/// Builds the test program of a stage for an exercise. None if it does not compile; Cargo
/// has then printed why.
fn build(exercise: Exercise, loud: bool) -> Result<Option<PathBuf>, String> {
    let mut cargo = Command::new("cargo");
    cargo
        .current_dir(ROOT)
        .args(["rustc", "--package", exercise.stage, "--test", "exercises"])
        .args(["--profile", "test", "--message-format"])
        .arg("json-render-diagnostics")
        .args((!loud).then_some("--quiet"))
        .args(["--", "--cfg", "learn", "--cfg", exercise.name]);
    let output = cargo.stderr(Stdio::inherit()).output();
    let output = output.map_err(|error| format!("cargo does not start: {error}"))?;
    if !output.status.success() {
        return Ok(None);
    }
    let messages = String::from_utf8_lossy(&output.stdout);
    let program = messages
        .lines()
        .filter(|line| line.contains("\"kind\":[\"test\"]"))
        .find_map(|line| line.split_once("\"executable\":\"")?.1.split_once('"'));
    let (program, _) = program.ok_or("cargo does not say where the test program is")?;
    Ok(Some(program.replace("\\\\", "\\").into()))
}

/// Runs the check of an exercise.
fn run(program: &Path) -> Result<Verdict, String> {
    let failed = |error| format!("{}: {error}", program.display());
    let mut command = Command::new(program);
    let mut child = command.env("RUST_BACKTRACE", "0").spawn().map_err(failed)?;
    let start = Instant::now();
    loop {
        if let Some(status) = child.try_wait().map_err(failed)? {
            return Ok(match status.code() {
                Some(0) => Verdict::Done,
                Some(3) => Verdict::ToDo,
                _ => Verdict::Wrong,
            });
        }
        if start.elapsed() > LONGEST {
            child.kill().map_err(failed)?;
            return Ok(Verdict::Endless);
        }
        sleep(Duration::from_millis(20));
    }
}
