//! The program of every stage.

use std::ffi::OsString;
use std::process::ExitCode;

use clap::FromArgMatches;
use clap::error::{ContextKind, ContextValue};
use common::{Error, Scene};
use measure::Stage;

use crate::Viewer;
use crate::grammar::{Command, CommandLine};
use crate::print::{print, warn};
use crate::{extremes, render, show};

/// Runs the program of `stage` with the arguments of this process.
///
/// Every error ends in one sentence on stderr and an exit code: 2 for a wrong
/// command line, 1 for all others.
#[must_use]
pub fn run(stage: &Stage, viewer: Option<&dyn Viewer>) -> ExitCode {
    run_with(stage, viewer, std::env::args_os())
}

/// Like [`run`], with the given arguments, the first of which is the program's name.
#[must_use]
pub fn run_with(
    stage: &Stage,
    viewer: Option<&dyn Viewer>,
    arguments: impl IntoIterator<Item = OsString>,
) -> ExitCode {
    let parsed = CommandLine::of(stage)
        .try_get_matches_from(arguments)
        .and_then(|matches| CommandLine::from_arg_matches(&matches));
    let outcome = match parsed {
        Ok(line) => execute(stage, viewer, line),
        Err(help_or_error) => {
            if let Some(scene) = scene_as_command(stage, &help_or_error) {
                let (stage, scene) = (stage.name, scene.name);
                warn(&format!(
                    "error: {scene} is a scene of {stage}, not a command; try: show {scene}"
                ));
                return ExitCode::from(2);
            }
            // A closed pipe is no error.
            let _ = help_or_error.print();
            return ExitCode::from(u8::from(help_or_error.use_stderr()) * 2);
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            warn(&format!("error: {error}"));
            ExitCode::from(error.exit_code())
        }
    }
}

/// The scene that stands in the place of a command.
fn scene_as_command<'a>(stage: &'a Stage, error: &clap::Error) -> Option<&'a Scene> {
    [ContextKind::InvalidSubcommand, ContextKind::InvalidArg]
        .into_iter()
        .find_map(|kind| match error.get(kind) {
            Some(ContextValue::String(word)) => stage.scenes.iter().find(|s| s.name == word),
            _ => None,
        })
}

fn execute(stage: &Stage, viewer: Option<&dyn Viewer>, line: CommandLine) -> Result<(), Error> {
    match line.command {
        None => show::show(stage, &stage.scenes[0], viewer, &line.showing),
        Some(Command::List) => {
            list(stage);
            Ok(())
        }
        Some(Command::Show { scene, showing }) => {
            show::show(stage, stage.scene(&scene)?, viewer, &showing)
        }
        Some(Command::Render {
            scenes,
            all,
            output,
            explain,
            options,
        }) => {
            let named = scenes.iter().map(|name| stage.scene(name));
            let scenes: Vec<&Scene> = if all {
                stage.scenes.iter().collect()
            } else {
                named.collect::<Result<_, _>>()?
            };
            render::render_to_files(stage, &scenes, output, explain, &options)
        }
        Some(Command::Report {
            names,
            quick,
            output,
        }) => crate::report::report(stage, &names, quick, output),
        Some(Command::Extremes { names }) => extremes::show_extremes(stage, &names),
    }
}

fn list(stage: &Stage) {
    let names = stage.scenes.iter().map(|scene| scene.name.len());
    let width = names.max().unwrap_or(0);
    for scene in &stage.scenes {
        print(&format!("{:width$}  {}", scene.name, scene.about));
    }
}
