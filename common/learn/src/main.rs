//! `cargo learn`: leads through the exercises of all stages, and checks them on save.
//!
//! An exercise is a section of the book's page `aNN-exercises.md` and a starter, which
//! is copied to a file of the student. The test program of the stage, built with that
//! one file, judges it: `testing::exercises!` explains how. So a file that does not
//! compile stops no other exercise and no test.

mod exercise;
mod files;
mod judgement;
mod progress;
mod watch;

use std::env;
use std::process::ExitCode;

use clap::builder::PossibleValuesParser;
use clap::{Arg, Command};

use exercise::Exercise;

/// All paths are relative to the workspace.
fn enter_workspace() -> Result<(), String> {
    let workspace = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
    env::set_current_dir(workspace).map_err(|error| format!("{workspace}: {error}"))
}

fn command(course: &[Exercise]) -> Command {
    let name = Arg::new("name")
        .help("An exercise")
        .value_name("EXERCISE")
        .value_parser(PossibleValuesParser::new(course.iter().map(|e| e.name)))
        .hide_possible_values(true);
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
        .subcommand(sub("hint", "Shows the hints of an exercise").arg(&or_next))
        .subcommand(sub("check", "Checks an exercise once").arg(&or_next))
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
    enter_workspace()?;
    let course = exercise::read_all()?;
    let matches = command(&course).get_matches();
    let (command, matches) = matches.subcommand().unwrap_or(("watch", &matches));
    if command == "list" {
        progress::list(&course);
        return Ok(ExitCode::SUCCESS);
    }
    let exercise = match matches.get_one::<String>("name") {
        Some(name) => course.iter().find(|e| e.name == name),
        None => progress::next(&course, None),
    };
    let Some(exercise) = exercise else {
        println!("all exercises are done; with a name, one is shown again");
        return Ok(ExitCode::SUCCESS);
    };
    match command {
        "hint" => println!("{}\n{}", exercise.title, exercise.hints.join("\n")),
        "reset" => files::reset(exercise)?,
        "check" => {
            files::begin(exercise)?;
            if !judgement::judge(exercise, true)? {
                return Ok(ExitCode::FAILURE);
            }
        }
        _ => watch::watch(&course, exercise)?,
    }
    Ok(ExitCode::SUCCESS)
}
