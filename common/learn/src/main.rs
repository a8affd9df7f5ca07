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

use std::process::ExitCode;

use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgMatches, Command};

use exercise::Course;
use judgement::{Verdict, judge};

fn command(names: &[&'static str]) -> Command {
    let name = |required: bool| {
        Arg::new("name")
            .help("An exercise [default: the next that is not done]")
            .value_name("EXERCISE")
            .value_parser(PossibleValuesParser::new(names))
            .hide_possible_values(true)
            .required(required)
    };
    let sub = |name, about| Command::new(name).about(about);
    Command::new("cargo learn")
        .about("Leads through the exercises of all stages, and checks them on save")
        .args_conflicts_with_subcommands(true)
        .arg(name(false))
        .subcommand(sub("list", "Lists all exercises, done and open"))
        .subcommand(sub("hint", "Shows the hints of an exercise").arg(name(false)))
        .subcommand(sub("check", "Checks an exercise once").arg(name(false)))
        .subcommand(sub("reset", "Begins an exercise anew, and keeps your file").arg(name(true)))
}

fn main() -> ExitCode {
    match Course::read().and_then(|course| run(&course)) {
        Ok(code) => code,
        Err(problem) => {
            eprintln!("cargo learn: {problem}");
            ExitCode::FAILURE
        }
    }
}

fn run(course: &Course) -> Result<ExitCode, String> {
    let names: Vec<_> = course.exercises.iter().map(|e| e.name).collect();
    let matches = command(&names).get_matches();
    let named = |matches: &ArgMatches| match matches.get_one::<String>("name") {
        Some(name) => course.named(name),
        None => progress::next(course),
    };
    match matches.subcommand() {
        Some(("list", _)) => progress::list(course),
        Some(("hint", matches)) => {
            let exercise = named(matches)?;
            println!("{}\n{}", exercise.title, exercise.hints.join("\n"));
        }
        Some(("check", matches)) => {
            let exercise = named(matches)?;
            files::begin(exercise)?;
            let verdict = judge(exercise, true)?;
            return Ok(ExitCode::from(u8::from(verdict != Verdict::Done)));
        }
        Some(("reset", matches)) => files::reset(named(matches)?)?,
        _ => watch::watch(course, named(&matches)?)?,
    }
    Ok(ExitCode::SUCCESS)
}
