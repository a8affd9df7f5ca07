//! The commands that measure and explain.

use std::env;
use std::ffi::OsString;
use std::path::PathBuf;
use std::process::{self, ExitCode};

use clap::{Args, Subcommand};
use common::{Error, Stage, text, workbook};

use crate::explain_pixel::{ExplainArgs, explain};
use crate::options::Options;
use crate::print::print;
use crate::target::{Replace, check_text, write_text};

/// The commands.
#[derive(Subcommand)]
pub enum Command {
    /// List every number behind a pixel, or how the numbers of a scene file change it
    Explain {
        /// The scene, as `list` names it, or a scene file that ends in .toml
        scene: String,
        #[command(flatten)]
        arguments: ExplainArgs,
    },
    /// Write a scene as text for others to read
    Export {
        /// The scene, as `list` names it, or a scene file that ends in .toml
        scene: String,

        /// The language: `toml`, for scene files, or `povray`
        #[arg(long, value_name = "LANGUAGE", value_parser = ["toml", "povray"])]
        to: String,

        /// The file, which ends in .toml or .pov as the language [default: standard output]
        #[arg(short, long, value_name = "FILE")]
        output: Option<PathBuf>,

        #[command(flatten)]
        other: Replace,

        #[command(flatten)]
        options: Options,
    },
    /// Report error against run time: a table, CSV and plots
    #[command(disable_help_flag = true)]
    Report(Arguments),
    /// Show the stiff and extreme cases; exit code 1 if one fails
    #[command(disable_help_flag = true)]
    Extremes(Arguments),
}

/// The arguments of a command that the laboratory runs.
#[derive(Args)]
pub struct Arguments {
    /// Those of the laboratory, which --help lists
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    arguments: Vec<OsString>,
}

/// Runs a command and returns the exit code.
pub fn execute(stage: &Stage, command: Command) -> Result<ExitCode, Error> {
    let done = match command {
        Command::Explain { scene, arguments } => explain(&stage.scene(&scene)?, &arguments),
        Command::Export {
            scene,
            to,
            output,
            other,
            options,
        } => {
            let scene = stage.scene(&scene)?;
            if let Some(path) = &output {
                let ending = if to == "toml" { "toml" } else { "pov" };
                check_text(path, ending, &scene, &options)?;
            }
            let text = scene.rays()?.export(&to, &options.settings(&scene)?)?;
            match output {
                Some(path) => write_text(&path, &text, &other),
                None => print(text.trim_end()),
            }
        }
        Command::Report(measured) => return run_laboratory(stage, "report", &measured),
        Command::Extremes(measured) => return run_laboratory(stage, "extremes", &measured),
    };
    done.map(|()| ExitCode::SUCCESS)
}

/// The folder of the workbook in which this program was built.
const WORKBOOK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// Runs a command of the stage's laboratory, in the profile of this build, and returns its exit
/// code. The laboratory is a program of its own, built when first asked for, so that nobody
/// waits for it on the way to the first picture. Cargo shows what it builds, and what it waits for.
fn run_laboratory(stage: &Stage, command: &str, measured: &Arguments) -> Result<ExitCode, Error> {
    let manifest = format!("{}/lab/Cargo.toml", stage.name);
    let manifest = workbook::with_file(&manifest, WORKBOOK.as_ref()).join(manifest);
    if !manifest.is_file() {
        let (name, missing) = (stage.name, text::path(&manifest));
        let none = format!("{name} has no laboratory: there is no {missing}");
        return Err(Error::Usage(none));
    }
    let mut cargo = process::Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.args(["run", "--manifest-path"]).arg(manifest);
    if !cfg!(debug_assertions) {
        cargo.arg("--release");
    }
    cargo.args(["--", command]).args(&measured.arguments);
    let status = cargo.status().map_err(Error::Laboratory)?;
    let code = status.code().and_then(|code| u8::try_from(code).ok());
    Ok(code.map_or(ExitCode::FAILURE, ExitCode::from))
}
