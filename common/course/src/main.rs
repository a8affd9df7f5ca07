//! `cargo course`: hands a workbook out to students, and grades what comes back. No student builds
//! it.

mod collected;
mod copies;
mod defence;
mod exercise_grading;
mod exercise_record;
mod grade;
mod grading_folder;
mod hand_in;
mod handed_file;
mod handout;
mod mistake;
mod outcome;
mod own_program;
mod packages;
mod picture_page;
mod program_output;
mod prove;
mod results;
mod sandbox;
mod sheet_grading;
mod spreadsheet;
mod stages;
mod structure;
mod submission;
mod unnamed;

use std::process::ExitCode;

use clap::Parser;
use common::text;
use learn::exercise;

use defence::Defence;
use grade::Grade;
use handout::Handout;
use mistake::Mistake;
use prove::Prove;

/// Hands a workbook out to students, and grades what comes back
#[derive(Parser)]
#[command(bin_name = "cargo course")]
enum Command {
    Handout(Handout),
    Grade(Grade),
    Mistake(Mistake),
    Defence(Defence),
    Prove(Prove),
}

fn main() -> ExitCode {
    match run(learn::parse()) {
        Ok(words) => {
            println!("{words}");
            ExitCode::SUCCESS
        }
        Err(problem) => {
            eprintln!("cargo course: {}", text::message(&problem));
            ExitCode::FAILURE
        }
    }
}

/// Runs a command, and returns its words.
fn run(command: Command) -> Result<String, String> {
    let course = exercise::read_all()?;
    match command {
        Command::Handout(handout) => handout.run(course),
        Command::Grade(grade) => grade.run(course),
        Command::Mistake(mistake) => mistake.run(course),
        Command::Defence(defence) => defence.run(),
        Command::Prove(prove) => prove.run(course),
    }
}
