//! The commands that measure and explain, which a workbook without laboratories lacks.

use std::path::PathBuf;

use clap::Subcommand;
use common::{Error, atomic_file};
use measure::Stage;

use crate::explain_pixel::{Explaining, explain_pixel};
use crate::extremes::{show_extremes, show_worst};
use crate::options::Options;
use crate::print::print;
use crate::report::report;

/// The commands.
#[derive(Subcommand)]
pub enum Command {
    /// List every number behind a pixel, by the lesson's own functions
    Explain {
        /// The scene, as `list` names it
        scene: String,
        #[command(flatten)]
        explaining: Explaining,
    },
    /// Write a scene as text for others to read
    Export {
        /// The scene, as `list` names it, or a scene file that ends in .toml
        scene: String,

        /// The language: `toml`, for scene files, or `povray`
        #[arg(long, value_name = "LANGUAGE", value_parser = ["toml", "povray"])]
        to: String,

        /// The file [default: standard output]
        #[arg(short, long, value_name = "FILE")]
        output: Option<PathBuf>,

        #[command(flatten)]
        options: Options,
    },
    /// Report error against run time: a table, CSV and plots
    Report {
        /// Experiments; or `scene` and scenes, for the error of their samples [default: all experiments]
        names: Vec<String>,

        /// Measure less, in seconds
        #[arg(long)]
        quick: bool,

        /// The folder for CSV and plots [default: out/report/]
        #[arg(short, long, value_name = "DIR")]
        output: Option<PathBuf>,
    },
    /// Show the stiff and extreme cases; exit code 1 if one fails
    Extremes {
        /// Beginnings of ids, such as A or A01 [default: all]
        names: Vec<String>,

        /// Search for the worst input of a shape's formulas, and print it as a test in Rust
        #[arg(long, value_name = "SHAPE", conflicts_with = "names")]
        search: Option<String>,
    },
}

/// Runs a command.
pub fn execute(stage: &Stage, command: Command) -> Result<(), Error> {
    match command {
        Command::Explain { scene, explaining } => explain_pixel(&stage.scene(&scene)?, &explaining),
        Command::Export {
            scene,
            to,
            output,
            options,
        } => {
            let scene = stage.scene(&scene)?;
            let text = scene.rays()?.export(&to, &options.settings(&scene)?)?;
            match output {
                Some(path) => atomic_file::write(&path, text.as_bytes()),
                None => print(text.trim_end()),
            }
        }
        Command::Report {
            names,
            quick,
            output,
        } => report(stage, &names, quick, output),
        Command::Extremes { names, search } => match search {
            Some(shape) => show_worst(stage, &shape),
            None => show_extremes(stage, &names),
        },
    }
}
