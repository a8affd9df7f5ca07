//! `judge`: builds the test program of a stage with a student's file, and runs it.

use std::process::{Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};
use std::{env, fs, io, thread};

use crate::exercise::Exercise;
use crate::lacking::lacking;
use crate::{files, progress};

/// The longest time that a check may take in seconds, unless `LEARN_SECONDS` is another.
const LONGEST: u64 = 10;

/// Time between two looks at a running program.
const PAUSE: Duration = Duration::from_millis(20);

/// Why a program that runs is to stop; none while it is to go on.
type Stop<'a> = &'a mut dyn FnMut() -> Option<String>;

/// Checks a student's file, and records whether it is done. Returns the verdict, which is an
/// error if it is not. A `loud` build shows that it goes on.
pub fn judge(e: &Exercise, loud: bool, stop: Stop) -> Result<String, String> {
    let verdict = |words: &str| format!("{}: {words}", e.name);
    progress::record(e, false)?;
    let text = fs::read_to_string(files::yours(e)).unwrap_or_default();
    if let Some(lacks) = lacking(e, &text) {
        return Err(verdict(&lacks));
    }
    let mut arguments = arguments(e);
    // After a save, only functions that have changed are compiled anew.
    arguments.extend(["-C", "incremental=target/learn"].map(str::to_owned));
    let program = build(e.name, loud, &arguments, stop)?;
    let longest = env::var("LEARN_SECONDS").ok();
    let longest = longest.and_then(|n| n.parse().ok()).unwrap_or(LONGEST);
    let late = format!("no end after {longest} seconds, probably a loop without end");
    let end = Instant::now() + Duration::from_secs(longest);
    let mut check = Command::new(program);
    let (ended, _) = run(check.env("RUST_BACKTRACE", "0"), &mut || {
        let is_late = Instant::now() > end;
        is_late.then(|| verdict(&late)).or_else(&mut *stop)
    })?;
    if !ended.success() {
        // The program has printed why.
        return Err(verdict("not yet"));
    }
    progress::record(e, true)?;
    Ok(verdict("done"))
}

/// Cargo's words for the test program of an exercise.
pub fn arguments(e: &Exercise) -> Vec<String> {
    // Messages name the file by its shortest path, and not by way of the test.
    let shortest = files::shortest(&format!("{}/exercises", e.stage));
    let long = format!("{}/tests/exercises/../../exercises", e.stage);
    let prefix = format!("--remap-path-prefix={long}={}", shortest.display());
    let words = "--test exercises --profile test --message-format json-render-diagnostics";
    let words = format!("rustc --package {} {words}", e.stage);
    let own = ["--", "--cfg", "learn", "-A", "unused", "--cfg", e.name];
    let all = words.split(' ').chain(own).chain([&*prefix]);
    all.map(str::to_owned).collect()
}

/// Builds a test program, and returns its path.
fn build(name: &str, loud: bool, arguments: &[String], stop: Stop) -> Result<String, String> {
    let mut cargo = Command::new("cargo");
    cargo.args((!loud).then_some("--quiet")).args(arguments);
    cargo.current_dir(files::workspace()).stdout(Stdio::piped());
    match run(&mut cargo, stop)? {
        (status, messages) if status.success() => program(&messages),
        // Cargo has printed why.
        _ => Err(format!("{name}: does not compile")),
    }
}

/// The path of the test program, by the messages of the build.
pub fn program(messages: &str) -> Result<String, String> {
    let program = messages
        .lines()
        .filter(|line| line.contains("\"kind\":[\"test\"]"))
        .find_map(|line| line.split_once("\"executable\":\"")?.1.split_once('"'));
    let (program, _) = program.ok_or("cargo does not say where the test program is")?;
    Ok(program.replace("\\\\", "\\"))
}

/// Runs a program, and returns its status and its piped output, unless it is stopped.
fn run(command: &mut Command, stop: Stop) -> Result<(ExitStatus, String), String> {
    let program = command.get_program().to_owned();
    let failed = |error| format!("{}: {error}", program.display());
    let mut child = command.spawn().map_err(failed)?;
    let output = child.stdout.take();
    let output = thread::spawn(|| output.map_or(Ok(String::new()), io::read_to_string));
    loop {
        if let Some(status) = child.try_wait().map_err(failed)? {
            let output = output.join().unwrap_or(Ok(String::new()));
            return Ok((status, output.map_err(failed)?));
        }
        if let Some(why) = stop() {
            child.kill().and_then(|()| child.wait()).map_err(failed)?;
            return Err(why);
        }
        thread::sleep(PAUSE);
    }
}
