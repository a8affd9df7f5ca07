//! `judge`: builds the test program of a stage with a student's file, and runs it.

use std::process::{Command, Stdio};

use crate::exercise::Exercise;
use crate::progress;

/// Checks a student's file and records if it is done, which is returned. A `loud` build
/// shows that it goes on.
pub fn judge(exercise: &Exercise, loud: bool) -> Result<bool, String> {
    let name = exercise.name;
    let Some(program) = build(exercise, loud)? else {
        println!("{name}: does not compile");
        return Ok(false);
    };
    let status = Command::new(&program).env("RUST_BACKTRACE", "0").status();
    let code = status
        .map_err(|error| format!("{program}: {error}"))?
        .code();
    match code {
        Some(0) => {
            println!("{name}: done");
            progress::record(exercise)?;
        }
        // The program has said why there is no judgement.
        Some(3) => {}
        _ => println!("{name}: not yet"),
    }
    Ok(code == Some(0))
}

/// Builds the test program of a stage for an exercise, and returns its path. None if it
/// does not compile; Cargo has then printed why.
fn build(exercise: &Exercise, loud: bool) -> Result<Option<String>, String> {
    let (stage, name) = (exercise.stage, exercise.name);
    let build = format!("rustc --package {stage} --test exercises --profile test");
    let output = Command::new("cargo")
        .args(build.split(' '))
        .args(["--message-format", "json-render-diagnostics"])
        .args((!loud).then_some("--quiet"))
        .args(["--", "--cfg", "learn", "--cfg", name, "-A", "unused"])
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| format!("cargo does not start: {error}"))?;
    if !output.status.success() {
        return Ok(None);
    }
    let messages = String::from_utf8_lossy(&output.stdout);
    let program = messages
        .lines()
        .filter(|line| line.contains("\"kind\":[\"test\"]"))
        .find_map(|line| line.split_once("\"executable\":\"")?.1.split_once('"'));
    let (program, _) = program.ok_or("cargo does not say where the test program is")?;
    Ok(Some(program.replace("\\\\", "\\")))
}
