//! `judge`: builds the test program of a stage with a student's file, and runs it.

use std::fmt::Write as _;
use std::process::Command;
use std::time::{Duration, Instant};
use std::{env, fs, io, thread};

use ::exercise::MARKED;
use common::text;

use crate::exercise::Exercise;
use crate::files;
use crate::missing_name::find_missing_name;
use crate::output::{Output, OutputReader};
use crate::process::run;
use crate::progress::Progress;
use crate::screen::{Screen, Space};
use crate::signature::explain_outside_error;

/// The longest time in seconds that a check may take without output, unless `LEARN_SECONDS` is
/// another.
const LONGEST: u64 = 10;

/// How many times as long it may take while it prints: to print much takes long, and is no loop
/// without end.
const LONGEST_WITH_OUTPUT: u32 = 6;

/// What goes on.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    Building,
    Checking,
}

impl Phase {
    /// The words about it. `what` follows them, such as `, 3 of 12: sphere`.
    pub fn words(self, what: &str, elapsed: Duration) -> String {
        let seconds = elapsed.as_secs();
        let words = match self {
            Self::Building if seconds > 4 => "building, about a minute",
            Self::Building => "building",
            Self::Checking => "checking",
        };
        let time = if seconds > 0 {
            format!(" ({seconds} s)")
        } else {
            String::new()
        };
        format!("{words}{what}{time}")
    }
}

/// Is told often how long the phase has lasted, and answers whether the check goes on.
pub type Watcher<'a> = &'a mut dyn FnMut(Phase, Duration) -> bool;

/// What a check says about a student's file.
#[derive(Default)]
pub struct Report {
    pub is_done: bool,
    /// The output of the student's program, or of the compiler.
    pub printed: String,
    /// What is wrong.
    pub words: String,
    /// What is true besides, for those who want to know more.
    pub remarks: String,
    /// The verdict in a line, such as `sphere: done`.
    pub verdict: String,
}

impl Report {
    fn new(e: &Exercise, verdict: &str) -> Self {
        Self {
            verdict: format!("{}: {verdict}", e.name),
            ..Self::default()
        }
    }

    /// What a student reads above the verdict: of a file that is right, only where its picture is,
    /// unless all is asked for.
    pub fn details(&self, screen: &Screen, is_all: bool) -> String {
        let is_all = is_all || !self.is_done;
        let mut text = String::new();
        if is_all {
            add_lines(&mut text, &self.printed);
        }
        add_lines(&mut text, &screen.wrap(&self.words));
        if is_all {
            add_lines(&mut text, &screen.wrap(&self.remarks));
        }
        text
    }

    /// Whether details without all leave something out.
    pub fn hides_something(&self) -> bool {
        self.is_done && !(self.printed.is_empty() && self.remarks.is_empty())
    }
}

fn add_lines(text: &mut String, lines: &str) {
    if !lines.is_empty() {
        *text += lines.trim_end();
        *text += "\n";
    }
}

/// Checks a student's file, and records whether it is done. Output is cut to the space.
pub fn judge(e: &Exercise, progress: &mut Progress, space: Space, watcher: Watcher) -> Report {
    let file = files::yours(e);
    let text = match fs::read_to_string(&file) {
        Ok(text) => text,
        Err(error) => return Report::new(e, &files::with_path(&file)(error)),
    };
    let report = match find_missing_name(e, &text) {
        Some(lacks) => Report::new(e, &lacks),
        None => match build_and_run(e, space, watcher) {
            Ok(Some(report)) => report,
            Ok(None) => return Report::new(e, "stopped"),
            Err(problem) => return Report::new(e, &problem),
        },
    };
    progress.record(e, &text, report.is_done);
    report
}

/// Judges a file that has the names which the check asks for. There is no report if the watcher
/// stops it.
fn build_and_run(e: &Exercise, space: Space, watcher: Watcher) -> Result<Option<Report>, String> {
    match build(e, space, watcher)? {
        Build::Program(program) => run_check(e, &program, space, watcher),
        Build::Failed(report) => Ok(Some(report)),
        Build::Stopped => Ok(None),
    }
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

/// What comes of a build.
enum Build {
    /// The path of the test program.
    Program(String),
    Failed(Report),
    Stopped,
}

/// Builds the test program of an exercise.
fn build(e: &Exercise, space: Space, watcher: Watcher) -> Result<Build, String> {
    let with_name = |error: io::Error| format!("cargo: {error}");
    let (mut messages, to_messages) = io::pipe().map_err(with_name)?;
    let (errors, to_errors) = io::pipe().map_err(with_name)?;
    let mut cargo = Command::new("cargo");
    cargo.arg("--quiet").args(arguments(e));
    // After a save, only functions that have changed are compiled again: those of a unit are
    // compiled together, so there are many units.
    cargo.args(["-C", "incremental=target/learn", "-C", "codegen-units=256"]);
    if let Some(width) = space.width {
        cargo.arg(format!("--diagnostic-width={width}"));
    }
    if console::colors_enabled() {
        cargo.env("CARGO_TERM_COLOR", "always");
    }
    cargo.current_dir(files::workspace());
    cargo.stdout(to_messages).stderr(to_errors);
    let messages = thread::spawn(move || io::read_to_string(&mut messages));
    let errors = OutputReader::start(errors);

    let start = Instant::now();
    let goes_on = &mut || watcher(Phase::Building, start.elapsed());
    let Some(status) = run(cargo, goes_on).map_err(with_name)? else {
        return Ok(Build::Stopped);
    };
    if !status.success() {
        let errors = errors.finish();
        let (first, more) = errors.beginning(space.lines);
        let form = explain_outside_error(e, &first);
        return Ok(Build::Failed(Report {
            printed: first + &say_cut(e, &errors, more),
            words: form.unwrap_or_default(),
            ..Report::new(e, "does not compile")
        }));
    }
    let messages = messages.join().unwrap_or(Ok(String::new()));
    Ok(Build::Program(program(&messages.map_err(with_name)?)?))
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

/// Runs the test program. There is no report if the watcher stops it.
fn run_check(
    e: &Exercise,
    program: &str,
    space: Space,
    watcher: Watcher,
) -> Result<Option<Report>, String> {
    let with_path = files::with_path(program.as_ref());
    let (output, to_output) = io::pipe().map_err(&with_path)?;
    let mut check = Command::new(program);
    check.env("RUST_BACKTRACE", "0").env(MARKED, "1");
    check.env("EXERCISE_DETAILS", "1");
    check.stdout(to_output.try_clone().map_err(&with_path)?);
    check.stderr(to_output);
    let output = OutputReader::start(output);

    let limit = env::var("LEARN_SECONDS").ok();
    let seconds = limit.and_then(|n| n.parse().ok()).unwrap_or(LONGEST);
    let limit = Duration::from_secs(seconds);
    let start = Instant::now();
    let mut late = None;
    let status = run(check, &mut || {
        let silence = output.so_far().last.unwrap_or(start).elapsed();
        let elapsed = start.elapsed();
        if silence > limit {
            let words = format!("no end after {seconds} seconds, probably a loop without end");
            late = Some(words);
        } else if elapsed > limit * LONGEST_WITH_OUTPUT {
            let (seconds, lines) = (elapsed.as_secs(), output.so_far().lines);
            late = Some(format!(
                "no end after {seconds} seconds, in which it has printed {lines} lines; print \
                 less, or look for a loop without end"
            ));
        }
        late.is_none() && watcher(Phase::Checking, elapsed)
    });
    let output = output.finish();
    let (is_done, verdict) = match (status.map_err(with_path)?, late) {
        (Some(status), _) if status.success() => (true, "done".to_owned()),
        // The program says why.
        (Some(_), _) => (false, "not yet".to_owned()),
        (None, Some(late)) => (false, late),
        (None, None) => return Ok(None),
    };
    let (first, more) = output.beginning(space.lines);
    // What a student's program prints may move the cursor.
    let printed = text::message(&first.replace('\t', "    "));
    Ok(Some(Report {
        is_done,
        printed: printed + &say_cut(e, &output, more),
        words: text::message(&output.words),
        remarks: text::message(&output.remarks),
        ..Report::new(e, &verdict)
    }))
}

/// Says how many lines of an output are not shown, and writes them to a file.
fn say_cut(e: &Exercise, output: &Output, more: usize) -> String {
    if more == 0 {
        return String::new();
    }
    let mut words = format!("\n… {more} more lines");
    let path = files::shortest(&format!("out/exercises/{}.txt", e.name));
    let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
    if folder.and_then(|()| fs::write(&path, &output.kept)).is_ok() {
        let part = if output.is_cut {
            "the first MiB"
        } else {
            "all"
        };
        let _ = write!(words, "; {} has {part} of them", text::path(&path));
    }
    words
}
