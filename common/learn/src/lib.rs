//! `cargo learn`: leads through the exercises of all stages, and checks them on save.
//!
//! An exercise is a row of the stage's `exercises.toml`, a section of the book's page
//! `aNN-exercises.md`, and a starter, which is copied to the student's file. The test program of the
//! stage judges it, built with this file alone, so that a file that does not compile stops no other
//! exercise. The grader of a course reads the same lists, and builds by the same words.

mod book;
mod build;
mod cargo_messages;
mod check;
pub mod exercise;
pub mod files;
mod hints;
mod keys;
mod output;
mod own_program;
mod page;
mod phase;
mod process;
mod progress;
mod public_items;
mod refusal;
mod report;
mod screen;
mod session;
pub mod sheet;
#[cfg(unix)]
mod signals;
mod starter;
mod student_file;
mod submit;
pub mod tokens;
mod watch;
mod wrap;

use std::env;
use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;
use std::time::Duration;

use clap::error::ContextKind;
use clap::{Args, CommandFactory, Parser, Subcommand};
use common::text;

pub use build::arguments;
pub use cargo_messages::{Kind, find_program, metadata, program_of};
pub use check::lacks;
use check::{ask_corpus, check_file};
use exercise::Exercise;
pub use files::MANIFEST;
use hints::hints;
pub use own_program::complete_manifest;
use phase::Phase;
use progress::Progress;
pub use refusal::refusal;
use screen::Screen;
pub use starter::{starter, with_code};
pub use submit::{SHEETS, is_added};

/// The exercises whose code the corpus of ray failures asks.
const SHAPES: [&str; 5] = ["plane", "axis_aligned_box", "triangle", "sphere", "disc"];

/// The least Jaro similarity of a word that may have been meant as a command.
const ALIKE: f64 = 0.9;

const ALL_DONE: &str = "all exercises are done; with a name, one is shown again";

/// Leads through the exercises of all stages, and checks them on save
#[derive(Parser)]
#[command(bin_name = "cargo learn", args_conflicts_with_subcommands = true)]
struct CommandLine {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    shown: OrNext,
}

#[derive(Args)]
struct OrNext {
    /// An exercise [default: the next that is not done]
    #[arg(value_name = "EXERCISE", value_parser = named)]
    name: Option<&'static Exercise>,
}

#[derive(Args)]
struct Check {
    #[command(flatten)]
    one: OrNext,
    /// Checks all files that you have begun
    #[arg(long, conflicts_with = "name")]
    all: bool,
}

#[derive(Subcommand)]
enum Command {
    /// Lists all exercises, done and open
    List,
    /// Shows the hints of an exercise
    Hint(OrNext),
    /// Checks an exercise once
    Check(Check),
    /// Asks your plane, box, triangle, sphere and disc the rays that broke ray tracers
    Corpus,
    /// Builds the book with your pictures in it
    Book,
    /// Begins an exercise again, and keeps your file
    Reset(OrNext),
    Submit(submit::Submit),
    Program(own_program::Command),
    Sheet(sheet::Command),
}

/// Runs the command of the command line.
#[must_use]
pub fn main() -> ExitCode {
    if let Err(problem) = run().and_then(|words| print(&words)) {
        eprintln!("cargo learn: {}", text::message(&problem));
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}

/// Runs the command, and returns its words.
fn run() -> Result<String, String> {
    // Without it, `reset` repairs the terminal.
    #[cfg(unix)]
    let _ = signals::clean_up_at_signals();
    let course = exercise::read_all()?;
    check_first_word()?;
    let CommandLine { command, shown } = parse();
    match command {
        None => with_chosen(&shown, course, |e| watch::watch(course, e)),
        Some(Command::List) => Ok(Screen::new().wrap(&Progress::read().list(course))),
        Some(Command::Hint(shown)) => with_chosen(&shown, course, |e| {
            let hints = Screen::new().wrap_markdown(&hints(e).join("\n\n"));
            Ok(format!("{}\n\n{hints}", e.title))
        }),
        Some(Command::Check(Check { all: true, .. })) => check_all(course),
        Some(Command::Check(Check { one, .. })) => with_chosen(&one, course, |e| check(course, e)),
        Some(Command::Corpus) => corpus(course),
        Some(Command::Book) => book::build(course),
        Some(Command::Reset(shown)) => with_chosen(&shown, course, student_file::reset),
        Some(Command::Submit(submit)) => submit.run(course),
        Some(Command::Program(program)) => program.run(course),
        Some(Command::Sheet(sheet)) => sheet.run(),
    }
}

/// Reads the command line. No argument begins with a hyphen, as clap supposes of a flag that it does not know.
#[must_use]
pub fn parse<T: Parser>() -> T {
    T::try_parse().unwrap_or_else(|mut error| {
        error.remove(ContextKind::Suggested);
        error.exit()
    })
}

/// The exercise of this name, or the only one of whose name it is a part. The error has the names that may be meant.
fn named(word: &str) -> Result<&'static Exercise, String> {
    let problem = match exercise::find(word) {
        Ok(e) => return Ok(e),
        Err(problem) => problem,
    };
    let commands = CommandLine::command();
    let mut names = commands.get_subcommands().map(clap::Command::get_name);
    if let Some(name) = names.find(|name| strsim::jaro(name, &word.to_lowercase()) > ALIKE) {
        return Err(format!("the nearest is the command {name}"));
    }
    let has_part = |e: &&Exercise| !word.is_empty() && e.name.contains(&word.replace('-', "_"));
    let found: Vec<_> = exercise::read_all()?.iter().filter(has_part).collect();
    match &*found {
        [] => Err(problem),
        [e] => Ok(e),
        several => {
            let names: Vec<_> = several.iter().map(|e| e.name).collect();
            Err(format!("it is a part of {}", names.join(", ")))
        }
    }
}

/// An error if several words begin with one that is no command.
fn check_first_word() -> Result<(), String> {
    let mut words = env::args().skip(1);
    if let (Some(word), Some(next)) = (words.next(), words.next())
        && !word.starts_with('-')
        && word != "help"
        && CommandLine::command().find_subcommand(&word).is_none()
    {
        let e = named(&word).map_err(|problem| format!("{}: {problem}", text::name(&word)))?;
        if !next.starts_with('-') {
            let name = e.name;
            return Err(format!(
                "a command stands before the name of its exercise, such as `cargo learn hint {name}`"
            ));
        }
    }
    Ok(())
}

/// Does something with the named exercise, or the next that is not done.
fn with_chosen(
    shown: &OrNext,
    course: &'static [Exercise],
    act: impl FnOnce(&'static Exercise) -> Result<String, String>,
) -> Result<String, String> {
    match shown.name.or_else(|| Progress::read().next(course, None)) {
        Some(e) => act(e),
        None => Ok(ALL_DONE.to_owned()),
    }
}

/// Checks an exercise, and prints all that the check says. Returns the verdict, which is an error
/// if the exercise is not done.
fn check(course: &[Exercise], e: &Exercise) -> Result<String, String> {
    student_file::begin(e)?;
    let screen = Screen::new();
    let mut progress = Progress::read();
    let report = check_file(e, &mut progress, screen.space(), &mut told(""));
    print(&report.details(&screen))?;
    if !report.is_done {
        return Err(report.verdict);
    }
    Ok(match progress.opened_by(course, e) {
        Some(opened) => screen.wrap(&format!("{}\n{opened}", report.verdict)),
        None => report.verdict,
    })
}

/// Checks all files that are begun, and returns how many of them are done; an error names those that
/// are not.
fn check_all(course: &[Exercise]) -> Result<String, String> {
    let mut progress = Progress::read();
    let space = Screen::new().space();
    let (mut count, mut open) = (0, Vec::new());
    for e in course.iter().filter(|e| student_file::is_begun(e)) {
        let about = format!(": {}", e.name);
        if !check_file(e, &mut progress, space, &mut told(&about)).is_done {
            open.push(e.name);
        }
        count += 1;
    }
    let words = format!(
        "{count} files are checked, {} of them are done",
        count - open.len()
    );
    if open.is_empty() {
        Ok(words)
    } else {
        Err(format!("{words}; open: {}", open.join(", ")))
    }
}

/// Asks the shapes that are begun the corpus of ray failures.
fn corpus(course: &[Exercise]) -> Result<String, String> {
    let space = Screen::new().space();
    let mut words = Vec::new();
    for e in course {
        if SHAPES.contains(&e.name) && student_file::is_begun(e) {
            words.push(ask_corpus(e, space, &mut told(&format!(": {}", e.name)))?);
        }
    }
    if words.is_empty() {
        let names = SHAPES.join(", ");
        return Err(format!(
            "the corpus asks your shapes, and none is begun: `cargo learn NAME` begins {names}"
        ));
    }
    Ok(Screen::new().wrap(&words.join("\n")))
}

/// Says on the standard error what goes on, if it takes longer than a second.
fn told(about: &str) -> impl FnMut(Phase, Duration) -> bool {
    let mut said = None;
    move |phase, elapsed| {
        if elapsed.as_secs() > 0 && said != Some(phase) {
            said = Some(phase);
            eprintln!("{}{about}", phase.words(elapsed));
        }
        true
    }
}

/// Prints a text. The reader of a pipe may close it early.
fn print(text: &str) -> Result<(), String> {
    if text.is_empty() {
        return Ok(());
    }
    match writeln!(io::stdout(), "{}", text.trim_end()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(error.to_string()),
        _ => Ok(()),
    }
}
