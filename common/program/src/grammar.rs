//! The grammar of the command line, the same for every stage.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

use crate::options::Options;

/// The whole command line; without a command the first scene is shown.
#[derive(Parser)]
#[command(disable_help_subcommand = true, args_conflicts_with_subcommands = true)]
pub struct CommandLine {
    #[command(subcommand)]
    pub command: Option<Command>,

    #[command(flatten)]
    pub showing: Showing,
}

/// How a scene is shown.
#[derive(Args)]
pub struct Showing {
    /// Open no window; write the PNG as if there were no display
    #[arg(long)]
    pub no_window: bool,

    #[command(flatten)]
    pub options: Options,
}

/// What to do.
#[derive(Subcommand)]
pub enum Command {
    /// List the scenes, one a line
    List,
    /// Show a scene in a window; without a display, write its PNG
    Show {
        /// The scene, as `list` names it
        scene: String,
        #[command(flatten)]
        showing: Showing,
    },
    /// Write scenes as PNG
    Render {
        /// The scenes, as `list` names them
        #[arg(required_unless_present = "all", conflicts_with = "all")]
        scenes: Vec<String>,

        /// Render all scenes of the stage
        #[arg(long)]
        all: bool,

        /// Where to: a PNG file for one scene, or a folder [default: out/]
        #[arg(short, long, value_name = "FILE|DIR")]
        output: Option<PathBuf>,

        /// Say what is left out of their making, and what that saves
        #[arg(long)]
        explain: bool,

        #[command(flatten)]
        options: Options,
    },
    /// Report error against run time: a table, CSV and plots
    Report {
        /// Experiments; or `scene` and scenes, to see what their samples are worth [default: all experiments]
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
    },
}
