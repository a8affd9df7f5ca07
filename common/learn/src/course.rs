//! The part of `cargo learn` for lecturers: hands a workbook out, and grades what comes back.

mod class;
mod grade;
mod grading_folder;
mod hand_in;
mod handout;
mod judge;
mod outcome;
mod platform;
mod refusal;
mod results;
mod sandbox;
mod submission;

use grade::Grade;
use handout::Handout;

use crate::exercise::Exercise;

/// The commands for lecturers.
#[derive(clap::Subcommand)]
pub enum Command {
    Handout(Handout),
    Grade(Grade),
}

/// Runs a command, and returns its words.
pub fn run(command: Command, course: &'static [Exercise]) -> Result<String, String> {
    match command {
        Command::Handout(handout) => handout.run(course),
        Command::Grade(grade) => grade.run(course),
    }
}

/// The exercises of the stages up to the last one.
fn exercises(
    course: &'static [Exercise],
    last: Option<&String>,
) -> Result<&'static [Exercise], String> {
    let is_last = |e: &Exercise| last.is_none_or(|last| e.stage.starts_with(last));
    let end = course.iter().rposition(is_last);
    let end = end.ok_or("no stage is so called; they are a01 to a07")?;
    Ok(&course[..=end])
}
