//! Measures all experiments of all stages on one thread, and writes one file of their figures, and their
//! plots. `cargo record` builds this program as `--release`, runs it, and puts both into the book.

mod renderers;

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use clap::Parser;
use common::{Error, atomic_file};
use measure::experiment::Experiment;
use measure::report::{self, Measured, Named};
use measure::{Laboratory, provenance, scene_report};
use rayon::ThreadPoolBuilder;

/// Measures the experiments of all stages for the book.
#[derive(Parser)]
#[command(version)]
struct Arguments {
    /// The folder for `recording.csv` and the plots
    folder: PathBuf,
    /// A line of the head of the recording, such as `commit: 123abc`
    #[arg(long, value_name = "KEY: WORDS")]
    head: Vec<String>,
}

/// The rounds in which the methods of an experiment take turns.
const ROUNDS: usize = 25;

/// The scene whose samples are measured beside the experiments.
const SAMPLED_SCENE: &str = "phong";

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    // Pictures are rendered on a thread of this pool: the one whose time is measured.
    let pool = ThreadPoolBuilder::new().num_threads(1).build();
    let outcome = match pool {
        Ok(pool) => pool.install(|| record(&arguments)),
        Err(error) => Err(error.into()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn record(arguments: &Arguments) -> Result<(), Error> {
    // Experiments with scenes borrow these as long as the program runs.
    let laboratories: &'static [Laboratory; 7] = Box::leak(Box::new(laboratories()));
    let mut all = Vec::new();
    for laboratory in laboratories {
        let mut measured = Vec::new();
        for experiment in experiments(laboratory)? {
            let (name, start) = (experiment.name.to_owned(), Instant::now());
            measured.push(Measured::new(experiment, ROUNDS, |_, _| {}));
            let seconds = start.elapsed().as_secs_f64();
            println!("{seconds:6.1} s  {} {name}", laboratory.stage.name);
        }
        all.push((laboratory.stage.name, measured));
    }
    write(&all, arguments)
}

/// The experiments of a stage, and those with its scenes.
fn experiments(laboratory: &'static Laboratory) -> Result<Vec<Experiment<'static>>, Error> {
    let mut experiments = (laboratory.experiments)();
    for scene in &laboratory.stage.scenes {
        if scene.name == SAMPLED_SCENE {
            experiments.push(scene_report::experiment(scene)?);
        }
        experiments.extend(renderers::experiment(scene));
    }
    Ok(experiments)
}

/// Writes the recording and the plots of measured stages.
fn write(all: &[(&str, Vec<Measured<'static>>)], arguments: &Arguments) -> Result<(), Error> {
    let mut head = provenance::here();
    let lines = arguments.head.iter();
    head.extend(lines.filter_map(|line| {
        let (key, words) = line.split_once(": ")?;
        Some((key, words.to_owned()))
    }));
    let mut rows = Vec::new();
    for (stage, experiments) in all {
        let short = stage.split('-').next().unwrap_or_default();
        for measured in experiments {
            rows.push(Named {
                name: format!("{short}.{}", measured.experiment.name),
                measured,
            });
            let opposite = report::opposite_of(measured, experiments);
            measured.write_plots(&arguments.folder, stage, opposite)?;
        }
    }
    let file = arguments.folder.join("recording.csv");
    atomic_file::write(&file, report::csv(&head, &rows).as_bytes())
}

fn laboratories() -> [Laboratory; 7] {
    [
        a01_lab::laboratory(),
        a02_lab::laboratory(),
        a03_lab::laboratory(),
        a04_lab::laboratory(),
        a05_lab::laboratory(),
        a06_lab::laboratory(),
        a07_lab::laboratory(),
    ]
}
