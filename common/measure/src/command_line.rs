//! The program of every laboratory: the commands `report` and `extremes` of its stage.

mod extremes;
mod report;

use std::ffi::OsString;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use common::Error;

use crate::Laboratory;

/// Measures the lesson: error against run time, stiff and extreme cases.
#[derive(Parser)]
#[command(version, disable_help_subcommand = true)]
enum Command {
    /// Report error against run time: a table, CSV and plots
    Report {
        /// Experiments; or `scene` and scenes, for the error of their samples [default: all experiments]
        names: Vec<String>,

        /// The folder for CSV and plots [default: out/report/]
        #[arg(short, long, value_name = "DIR")]
        output: Option<PathBuf>,
    },
    /// Show the stiff and extreme cases; exit code 1 if one fails
    Extremes {
        /// Beginnings of ids, such as A or A01 [default: all]
        names: Vec<String>,
    },
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
    match Command::try_parse_from(arguments) {
        Ok(command) => {
            let done = execute(laboratory, command);
            command_line::exit_code(done.map(|()| ExitCode::SUCCESS))
        }
        Err(help_or_error) => command_line::print_clap_error(&help_or_error),
    }
}

fn execute(laboratory: &Laboratory, command: Command) -> Result<(), Error> {
    match command {
        Command::Report { names, output } => report::report(laboratory, &names, output),
        Command::Extremes { names } => extremes::show_extremes(laboratory, &names),
    }
}
