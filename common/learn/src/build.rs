//! `build`: compiles the test program of a stage with a student's file, or the student's own program.

use std::ffi::OsString;
use std::fs::{File, TryLockError};
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};
use std::{env, io, thread};

use crate::cargo_messages::{Kind, find_program, metadata, program_of};
use crate::exercise::Exercise;
use crate::files;
use crate::output::OutputReader;
use crate::phase::{Phase, Watcher};
use crate::process::run;
use crate::screen::Space;

/// Time between two looks whether another cargo builds.
const PAUSE: Duration = Duration::from_millis(50);

/// What comes of a build.
pub enum Build {
    /// The path of the program.
    Program(String),
    /// What the compiler prints.
    Failed(String),
    Stopped,
}

/// Builds the test program of an exercise.
pub fn build(e: &Exercise, space: Space, watcher: Watcher) -> Result<Build, String> {
    let mut cargo = Command::new("cargo");
    cargo.arg("--quiet").args(arguments(e.stage, &[e.name]));
    // After a save, only functions that have changed are compiled again: those of a unit are
    // compiled together, so there are many units.
    cargo.args(["-C", "incremental=target/learn", "-C", "codegen-units=256"]);
    if let Some(width) = space.width {
        cargo.arg(format!("--diagnostic-width={width}"));
    }
    cargo.current_dir(files::workspace());
    let lock = files::workspace().join(target()).join("debug/.cargo-lock");
    compile(cargo, Kind::Test, &lock, space, watcher)
}

/// Builds the student's own program, the one that `cargo run` runs.
pub fn build_own(folder: &Path, space: Space, watcher: Watcher) -> Result<Build, String> {
    let name = program_of(&metadata(folder)?)?;
    let mut cargo = Command::new("cargo");
    cargo.args(["--quiet", "build", "--release", "--bin", &name]);
    cargo.args(["--message-format", "json-render-diagnostics"]);
    cargo.current_dir(folder);
    let lock = folder.join(target()).join("release/.cargo-lock");
    compile(cargo, Kind::Bin(&name), &lock, space, watcher)
}

/// Runs cargo, as soon as no other one has locked the folder, and returns the program of this kind that it has
/// built.
fn compile(
    mut cargo: Command,
    kind: Kind,
    lock: &Path,
    space: Space,
    watcher: Watcher,
) -> Result<Build, String> {
    let with_name = |error: io::Error| format!("cargo: {error}");
    let mut start = Instant::now();
    while is_locked(lock) {
        if !watcher(Phase::Waiting, start.elapsed()) {
            return Ok(Build::Stopped);
        }
        thread::sleep(PAUSE);
    }
    start = Instant::now();
    let (mut messages, to_messages) = io::pipe().map_err(with_name)?;
    let (errors, to_errors) = io::pipe().map_err(with_name)?;
    if console::colors_enabled() {
        cargo.env("CARGO_TERM_COLOR", "always");
    }
    cargo.stdout(to_messages).stderr(to_errors);
    let messages = thread::spawn(move || io::read_to_string(&mut messages));
    let errors = OutputReader::start(errors);

    let goes_on = &mut || watcher(Phase::Building, start.elapsed());
    let Some(status) = run(cargo, goes_on).map_err(with_name)? else {
        return Ok(Build::Stopped);
    };
    if !status.success() {
        return Ok(Build::Failed(errors.finish().beginning(space.lines)));
    }
    let messages = messages.join().unwrap_or(Ok(String::new()));
    let program = find_program(&messages.map_err(with_name)?, kind)?;
    Ok(Build::Program(program))
}

/// The folder of builds, as the environment has it.
fn target() -> OsString {
    env::var_os("CARGO_TARGET_DIR").unwrap_or("target".into())
}

/// Whether another cargo builds in the same folder: cargo would wait for it without a word.
fn is_locked(lock: &Path) -> bool {
    let Ok(lock) = File::open(lock) else {
        return false;
    };
    matches!(lock.try_lock(), Err(TryLockError::WouldBlock))
}

/// Cargo's words for the test program of a stage with the files of these exercises.
#[must_use]
pub fn arguments(stage: &str, names: &[&str]) -> Vec<String> {
    // Messages name the file by its shortest path, and not by way of the test.
    let shortest = files::shortest(&format!("{stage}/exercises"));
    let long = format!("{stage}/tests/exercises/../../exercises");
    let prefix = format!("--remap-path-prefix={long}={}", shortest.display());
    let words = "--test exercises --profile test --message-format json-render-diagnostics";
    let words = format!("rustc --package {stage} {words}");
    // The stages' profile optimises the check of a file, too, which takes longer than all its answers.
    let own = "-- -A unused -C opt-level=0";
    let names = names.iter().flat_map(|name| ["--cfg", name]);
    let all = words.split(' ').chain(own.split(' '));
    let all = all.chain([&*prefix]).chain(names);
    all.map(str::to_owned).collect()
}
