//! The program of every laboratory: the commands `report` and `extremes` of its stage.

mod extremes;
mod report;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::Parser;
use command_line::Measure;
use common::Error;

use crate::Laboratory;

/// Measures the lesson: error against run time, stiff and extreme cases.
#[derive(Parser)]
#[command(version, disable_help_subcommand = true)]
struct CommandLine {
    #[command(subcommand)]
    measure: Measure,
}

/// Runs the program of a laboratory with the arguments of this process.
#[must_use]
pub fn run(laboratory: &Laboratory) -> ExitCode {
    run_with(laboratory, std::env::args_os())
}

/// Like [`run`], with the given arguments, the first of which is the program's name.
#[must_use]
pub fn run_with(
    laboratory: &Laboratory,
    arguments: impl IntoIterator<Item = OsString>,
) -> ExitCode {
    match CommandLine::try_parse_from(arguments) {
        Ok(CommandLine { measure }) => {
            let done = execute(laboratory, measure);
            command_line::exit_code(done.map(|()| ExitCode::SUCCESS))
        }
        Err(help_or_error) => command_line::print_clap_error(help_or_error),
    }
}

fn execute(laboratory: &Laboratory, measure: Measure) -> Result<(), Error> {
    match measure {
        Measure::Report { names, output } => report::report(laboratory, &names, output),
        Measure::Extremes { names } => extremes::show_extremes(laboratory, &names),
    }
}
