//! The part of `cargo learn` for lecturers and for handing in. Its libraries are built when it
//! is first used.

mod grade;
mod handout;
mod refusal;
mod result_file;
mod sandbox;
mod submission;
mod submit;

use std::path::Path;

use clap::{Arg, ArgMatches, Command};

use crate::exercise::Exercise;

pub fn commands() -> Vec<Command> {
    vec![submit::command(), handout::command(), grade::command()]
}

/// Runs a command of this part, and returns what there is to print.
pub fn run(
    command: &str,
    course: &'static [Exercise],
    matches: &ArgMatches,
) -> Result<String, String> {
    match command {
        "grade" => grade::run(course, matches),
        "handout" => handout::run(course, matches),
        _ => submit::run(course, matches),
    }
}

fn until() -> Arg {
    let until = Arg::new("until").long("until").value_name("STAGE");
    until.help("The last stage, as a04 [default: all stages]")
}

/// The exercises of the stages up to the last one.
fn exercises(
    course: &'static [Exercise],
    matches: &ArgMatches,
) -> Result<Vec<&'static Exercise>, String> {
    let last = matches.get_one::<String>("until");
    let is_last = |e: &Exercise| last.is_none_or(|last| e.stage.starts_with(last));
    let Some(end) = course.iter().rposition(is_last) else {
        return Err("no stage is so called; they are a01 to a07".to_owned());
    };
    Ok(course[..=end].iter().collect())
}

/// The stages of exercises, which are in the order of the course.
fn stages(exercises: &[&Exercise]) -> Vec<&'static str> {
    let mut stages: Vec<_> = exercises.iter().map(|e| e.stage).collect();
    stages.dedup();
    stages
}

/// The words about a file that cannot be read or written.
fn failed(path: &Path) -> impl Fn(std::io::Error) -> String {
    move |error| format!("{}: {error}", path.display())
}
