//! `cargo learn`: leads through the exercises of all stages, and checks them on save.
//!
//! An exercise is a section of the book's page `aNN-exercises.md`, or a comment that sets the task,
//! and a starter, which is copied to the student's file. The test program of the stage judges it,
//! built with this file alone, so that a file that does not compile stops no other exercise.

mod book;
mod course;
mod editor;
mod exercise;
mod files;
mod judgement;
mod keys;
mod lacking;
mod own;
mod progress;
mod submit;
mod watch;

use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;

use clap::{Args, Parser, Subcommand};

use exercise::Exercise;

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
    #[arg(value_name = "EXERCISE", value_parser = exercise::find)]
    name: Option<&'static Exercise>,
}

#[derive(Subcommand)]
enum Command {
    /// Lists all exercises, done and open
    List,
    /// Writes the settings of rust-analyzer for VS Code
    Editor,
    /// Shows the hints of an exercise
    Hint(OrNext),
    /// Checks an exercise once
    Check(OrNext),
    /// Builds the book with your pictures in it
    Book,
    /// Begins an exercise anew, and keeps your file
    Reset(OrNext),
    Submit(submit::Submit),
    #[command(flatten)]
    ForLecturers(course::Command),
}

fn main() -> ExitCode {
    if let Err(problem) = run().and_then(|words| print(&words)) {
        eprintln!("cargo learn: {problem}");
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}

/// Runs the command, and returns its words.
fn run() -> Result<String, String> {
    let course = exercise::read_all()?;
    let CommandLine { command, shown } = CommandLine::parse();
    let chosen = match &command {
        Some(Command::Hint(chosen) | Command::Check(chosen) | Command::Reset(chosen)) => chosen,
        _ => &shown,
    };
    let next = chosen.name.or_else(|| progress::next(course, None));
    Ok(match (command, next) {
        (Some(Command::List), _) => progress::list(course),
        (Some(Command::Editor), _) => editor::write_settings()?,
        (Some(Command::Book), _) => book::build(course)?,
        (Some(Command::Submit(submit)), _) => submit.run(course)?,
        (Some(Command::ForLecturers(it)), _) => course::run(it, course)?,
        (_, None) => "all exercises are done; with a name, one is shown again".to_owned(),
        (None, Some(e)) => watch::watch(course, e)?,
        (Some(Command::Hint(_)), Some(e)) => format!("{}\n{}", e.title, e.hints.join("\n")),
        (Some(Command::Check(_)), Some(e)) => {
            files::begin(e)?;
            judgement::judge(e, true, &mut || None)?
        }
        (Some(Command::Reset(_)), Some(e)) => files::reset(e)?,
    })
}

/// Prints a text. The reader of a pipe may close it early.
fn print(text: &str) -> Result<(), String> {
    match writeln!(io::stdout(), "{text}") {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(error.to_string()),
        _ => Ok(()),
    }
}
