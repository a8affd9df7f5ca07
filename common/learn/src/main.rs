//! `cargo learn`: leads through the exercises of all stages, and checks them on save.
//!
//! An exercise is a section of the book's page `aNN-exercises.md` and a starter, which is
//! copied to the student's file. The test program of the stage judges it, built with this file
//! alone, so that a file that does not compile stops no other exercise.

mod book;
#[cfg(feature = "course")]
mod course;
mod editor;
mod exercise;
mod files;
mod judgement;
mod keys;
mod progress;
mod watch;

use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;
#[cfg(not(feature = "course"))]
use std::{env, process};

use clap::{Arg, Command};

use exercise::Exercise;

fn command(course: &'static [Exercise]) -> Command {
    let name = Arg::new("name")
        .help("An exercise")
        .value_name("EXERCISE")
        .value_parser(move |name: &str| exercise::find(course, name));
    let or_next = name
        .clone()
        .help("An exercise [default: the next that is not done]");
    let sub = |name, about| Command::new(name).about(about);
    Command::new("cargo learn")
        .bin_name("cargo learn")
        .about("Leads through the exercises of all stages, and checks them on save")
        .args_conflicts_with_subcommands(true)
        .arg(&or_next)
        .subcommand(sub("list", "Lists all exercises, done and open"))
        .subcommand(sub(
            "editor",
            "Writes the settings of rust-analyzer for VS Code",
        ))
        .subcommand(sub("hint", "Shows the hints of an exercise").arg(&or_next))
        .subcommand(sub("check", "Checks an exercise once").arg(&or_next))
        .subcommand(sub("book", "Builds the book with your pictures in it"))
        .subcommand(
            sub("reset", "Begins an exercise anew, and keeps your file").arg(name.required(true)),
        )
}

fn main() -> ExitCode {
    run().unwrap_or_else(|problem| {
        eprintln!("cargo learn: {problem}");
        ExitCode::FAILURE
    })
}

fn run() -> Result<ExitCode, String> {
    #[cfg(not(feature = "course"))]
    if env::args()
        .nth(1)
        .is_some_and(|name| ["submit", "handout", "grade"].contains(&&*name))
    {
        return with_course();
    }
    let course = exercise::read_all()?.leak();
    let command = command(course);
    #[cfg(feature = "course")]
    let command = command.subcommands(course::commands());
    let matches = command.get_matches();
    let (command, matches) = matches.subcommand().unwrap_or(("watch", &matches));
    match command {
        "book" => return book::build(course),
        #[cfg(feature = "course")]
        "submit" | "handout" | "grade" => return print(&course::run(command, course, matches)?),
        "list" => return print(&progress::list(course)),
        "editor" => return print(&editor::write_settings()?),
        _ => {}
    }
    let exercise = match matches.get_one("name") {
        Some(exercise) => Some(*exercise),
        None => progress::next(course, None),
    };
    let Some(exercise) = exercise else {
        return print("all exercises are done; with a name, one is shown again");
    };
    match command {
        "hint" => {
            let (title, hints) = (exercise.title, exercise.hints.join("\n"));
            return print(&format!("{title}\n{hints}"));
        }
        "reset" => files::reset(exercise)?,
        "check" => {
            files::begin(exercise)?;
            if !judgement::judge(exercise, true, &mut || false)? {
                return Ok(ExitCode::FAILURE);
            }
        }
        _ => watch::watch(course, exercise)?,
    }
    Ok(ExitCode::SUCCESS)
}

/// Runs this program with the feature `course`, which takes a while to build, once.
#[cfg(not(feature = "course"))]
fn with_course() -> Result<ExitCode, String> {
    let words = "run --quiet --package learn --features course --";
    let mut cargo = process::Command::new("cargo");
    let status = cargo
        .args(words.split(' '))
        .args(env::args_os().skip(1))
        .status();
    let code = status.map_err(|error| format!("cargo: {error}"))?.code();
    Ok(ExitCode::from(code.map_or(1, |code| code as u8)))
}

/// Prints a text. The reader of a pipe may close it early.
fn print(text: &str) -> Result<ExitCode, String> {
    match writeln!(io::stdout(), "{text}") {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(error.to_string()),
        _ => Ok(ExitCode::SUCCESS),
    }
}
