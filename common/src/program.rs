//! The program of every stage.

mod explain;
mod extremes;
mod grammar;
mod render;
#[cfg(feature = "report")]
mod report;
mod show;
mod target;

use std::ffi::OsString;
use std::io::{self, Write};
use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches};

use crate::{Error, Scene, Stage, Viewer};
use grammar::{Command, CommandLine};

pub(crate) use target::make_default_folder;
pub use target::picture_name;

/// Runs the program of `stage` with the arguments of this process.
///
/// Whatever goes wrong ends in one sentence on stderr and an exit code: 2 for
/// a wrong command line, 1 for the rest.
#[must_use]
pub fn run(stage: &Stage, viewer: Option<&dyn Viewer>) -> ExitCode {
    run_with(stage, viewer, std::env::args_os())
}

/// Like [`run`] with other arguments, the first of which is the program's name.
#[must_use]
pub fn run_with(
    stage: &Stage,
    viewer: Option<&dyn Viewer>,
    arguments: impl IntoIterator<Item = OsString>,
) -> ExitCode {
    let grammar = CommandLine::command().name(stage.name).about(stage.about);
    let parsed = grammar
        .try_get_matches_from(arguments)
        .and_then(|matches| CommandLine::from_arg_matches(&matches));
    let outcome = match parsed {
        Ok(line) => execute(stage, viewer, line),
        Err(help_or_error) => {
            // A closed pipe is no reason to complain.
            let _ = help_or_error.print();
            return ExitCode::from(u8::from(help_or_error.use_stderr()) * 2);
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            complain(&format!("error: {error}"));
            ExitCode::from(error.exit_code())
        }
    }
}

fn execute(stage: &Stage, viewer: Option<&dyn Viewer>, line: CommandLine) -> Result<(), Error> {
    match line.command {
        None => show::show(stage, &stage.scenes[0], viewer, &line.options),
        Some(Command::List) => {
            list(stage);
            Ok(())
        }
        Some(Command::Show { scene, options }) => {
            show::show(stage, stage.scene(&scene)?, viewer, &options)
        }
        Some(Command::Render {
            scenes,
            all,
            output,
            explain,
            overrides,
        }) => {
            let named = scenes.iter().map(|name| stage.scene(name));
            let scenes: Vec<&Scene> = if all {
                stage.scenes.iter().collect()
            } else {
                named.collect::<Result<_, _>>()?
            };
            render::render_to_files(stage, &scenes, output, explain, &overrides)
        }
        #[cfg(feature = "report")]
        Some(Command::Report {
            names,
            quick,
            output,
        }) => report::report(stage, &names, quick, output),
        #[cfg(not(feature = "report"))]
        Some(Command::Report { .. }) => Err(Error::Usage(
            "this build has no reports; the feature `report` brings them".to_owned(),
        )),
        Some(Command::Extremes { names }) => extremes::show_extremes(stage, &names),
    }
}

fn list(stage: &Stage) {
    let names = stage.scenes.iter().map(|scene| scene.name.len());
    let width = names.max().unwrap_or(0);
    for scene in &stage.scenes {
        say(&format!("{:width$}  {}", scene.name, scene.about));
    }
}

/// Prints a line; a reader that has closed the pipe has seen enough.
fn say(line: &str) {
    let _ = writeln!(io::stdout(), "{line}");
}

/// Prints a line on stderr, where nobody may listen either.
fn complain(line: &str) {
    let _ = writeln!(io::stderr(), "{line}");
}
