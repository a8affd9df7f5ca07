//! The commands that measure and explain.

use std::env;
use std::ffi::OsString;
use std::path::PathBuf;
use std::process::{self, ExitCode};

use clap::Subcommand;
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
    #[command(flatten)]
    Measure(Measure),
}

/// The commands of a stage's laboratory.
#[derive(Subcommand)]
pub enum Measure {
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

impl Measure {
    /// The command line for the laboratory.
    fn words(self) -> Vec<OsString> {
        let mut words: Vec<OsString> = Vec::new();
        let names = match self {
            Self::Report { names, output } => {
                words.push("report".into());
                if let Some(folder) = output {
                    words.extend(["--output".into(), folder.into()]);
                }
                names
            }
            Self::Extremes { names } => {
                words.push("extremes".into());
                names
            }
        };
        words.push("--".into());
        words.extend(names.into_iter().map(OsString::from));
        words
    }
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
        Command::Measure(measure) => return run_laboratory(stage, measure),
    };
    done.map(|()| ExitCode::SUCCESS)
}

/// The folder of the workbook in which this program was built.
const WORKBOOK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// Runs a command of the stage's laboratory, in the profile of this build, and returns its exit
/// code. The laboratory is a program of its own, built when first asked for, so that nobody
/// waits for it on the way to the first picture. Cargo shows what it builds, and what it waits for.
fn run_laboratory(stage: &Stage, measure: Measure) -> Result<ExitCode, Error> {
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
    cargo.arg("--").args(measure.words());
    let status = cargo.status().map_err(Error::Laboratory)?;
    let code = status.code().and_then(|code| u8::try_from(code).ok());
    Ok(code.map_or(ExitCode::FAILURE, ExitCode::from))
}
