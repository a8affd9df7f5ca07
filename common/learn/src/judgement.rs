//! `judge`: builds the test program of a stage with a student's file, and runs it.

use std::process::{Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};
use std::{env, io, thread};

use crate::exercise::Exercise;
use crate::{files, progress};

/// The longest time that a check may take in seconds, unless `LEARN_SECONDS` is another.
const LONGEST: u64 = 10;

/// Time between two looks at a running program.
const PAUSE: Duration = Duration::from_millis(20);

/// Checks a student's file, unless it `stops` before. Records whether it is done, and returns
/// it. A `loud` build shows that it goes on.
pub fn judge(e: &Exercise, loud: bool, stops: &mut dyn FnMut() -> bool) -> Result<bool, String> {
    let name = e.name;
    progress::record(e, false)?;
    let mut build = cargo(loud, &arguments(e));
    // After a save, only functions that have changed are compiled anew.
    build.args(["-C", "incremental=target/learn"]);
    let Some((built, messages)) = run(&mut build, stops)? else {
        return Ok(false);
    };
    if !built.success() {
        // Cargo has printed why.
        println!("{name}: does not compile");
        return Ok(false);
    }
    let longest = env::var("LEARN_SECONDS").ok();
    let longest = longest.and_then(|n| n.parse().ok()).unwrap_or(LONGEST);
    let end = Instant::now() + Duration::from_secs(longest);
    let mut check = Command::new(program(&messages)?);
    let ended = run(check.env("RUST_BACKTRACE", "0"), &mut || {
        let is_late = Instant::now() > end;
        if is_late {
            println!("{name}: no end after {longest} seconds, probably a loop without end");
        }
        is_late || stops()
    })?;
    match ended.map(|(status, _)| status.code()) {
        Some(Some(0)) => {
            println!("{name}: done");
            progress::record(e, true)?;
            return Ok(true);
        }
        // The program has said what is missing, or is stopped.
        Some(Some(3)) | None => {}
        _ => println!("{name}: not yet"),
    }
    Ok(false)
}

/// Builds the test program of a stage that proves its exercises, and returns its path.
#[cfg(not(handout))]
pub fn proofs(stage: &str) -> Result<String, String> {
    match run(&mut cargo(false, &of_stage(stage)), &mut || false)? {
        Some((status, messages)) if status.success() => program(&messages),
        _ => Err(format!("the checks of {stage} do not compile")),
    }
}

/// Cargo's words for the test program of a stage.
fn of_stage(stage: &str) -> Vec<String> {
    let words = "--test exercises --profile test --message-format json-render-diagnostics";
    let words = format!("rustc --package {stage} {words}");
    words.split(' ').map(str::to_owned).collect()
}

/// Cargo's words for the test program of an exercise.
pub fn arguments(e: &Exercise) -> Vec<String> {
    // Messages name the file by its shortest path, and not by way of the test.
    let shortest = files::shortest(&format!("{}/exercises", e.stage));
    let long = format!("{}/tests/exercises/../../exercises", e.stage);
    let prefix = format!("--remap-path-prefix={long}={}", shortest.display());
    let own = "-- --cfg learn -A unused --cfg";
    let own = own.split(' ').chain([e.name, &*prefix]);
    of_stage(e.stage)
        .into_iter()
        .chain(own.map(str::to_owned))
        .collect()
}

fn cargo(loud: bool, arguments: &[String]) -> Command {
    let mut cargo = Command::new("cargo");
    cargo
        .args((!loud).then_some("--quiet"))
        .args(arguments)
        .current_dir(files::workspace())
        .stdout(Stdio::piped());
    cargo
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

/// Runs a program, and returns its status and its piped output; none if it `stops` before.
fn run(
    command: &mut Command,
    stops: &mut dyn FnMut() -> bool,
) -> Result<Option<(ExitStatus, String)>, String> {
    let program = command.get_program().to_owned();
    let failed = |error| format!("{}: {error}", program.display());
    let mut child = command.spawn().map_err(failed)?;
    let output = child.stdout.take();
    let output = thread::spawn(|| output.map_or(Ok(String::new()), io::read_to_string));
    loop {
        if let Some(status) = child.try_wait().map_err(failed)? {
            let output = output.join().unwrap_or(Ok(String::new()));
            return Ok(Some((status, output.map_err(failed)?)));
        }
        if stops() {
            child.kill().and_then(|()| child.wait()).map_err(failed)?;
            return Ok(None);
        }
        thread::sleep(PAUSE);
    }
}
