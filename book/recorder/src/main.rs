//! Measures all experiments of all stages in one build and on one thread, and writes a file for each of
//! them. `cargo record` builds this program fully optimised, and as `--release`, and runs both.

mod renderers;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::Instant;
use std::{fs, io};

use clap::Parser;
use common::{Renderer, atomic_file};
use measure::experiment::Experiment;
use measure::report::Measured;
use measure::{Effort, Laboratory, left_out_report, scene_report};
use rayon::ThreadPoolBuilder;

/// Measures the experiments of all stages for the book.
#[derive(Parser)]
#[command(version)]
struct Arguments {
    /// The folder for the files, one folder in it for each stage
    folder: PathBuf,
    /// Stages or experiments, such as a04 or a04.sphere-far [default: all]
    names: Vec<String>,
    /// Where the measurement ran, in words, for the heads of the files
    #[arg(long, default_value = "not pinned to a core")]
    conditions: String,
    /// Replaces also earlier times that count as equal to the new ones
    #[arg(long)]
    afresh: bool,
}

/// The rounds in which the methods of an experiment take turns.
const ROUNDS: usize = 25;

/// The scene whose samples are measured beside the experiments.
const SAMPLED_SCENE: &str = "phong";

/// The scenes of which the work is measured that they do not need.
const LEFT_OUT: [&str; 4] = ["sphere", "aab", "box-transformations", "disc"];

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    // Pictures are rendered on a thread of this pool: the one whose time is measured.
    let pool = ThreadPoolBuilder::new().num_threads(1).build();
    let outcome = match pool {
        Ok(pool) => pool.install(|| record(&arguments)),
        Err(error) => Err(error.to_string()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn record(arguments: &Arguments) -> Result<(), String> {
    let mut recorder = Recorder {
        arguments,
        known: Vec::new(),
    };
    for laboratory in laboratories() {
        let stage = laboratory.stage.name;
        for experiment in (laboratory.experiments)() {
            recorder.record(stage, experiment)?;
        }
        for scene in &laboratory.stage.scenes {
            if scene.name == SAMPLED_SCENE {
                let experiment = scene_report::experiment(scene);
                recorder.record(stage, experiment.map_err(|error| error.to_string())?)?;
            }
            if renderers::SCENES.contains(&scene.name) {
                let name = format!("render-{}", scene.name);
                recorder.record(stage, renderers::experiment(&name, scene))?;
            }
            if LEFT_OUT.contains(&scene.name) {
                for (renderer, suffix) in [(Renderer::Lesson, ""), (Renderer::Engine, "-engine")] {
                    let name = format!("left-out-{}{suffix}", scene.name);
                    let experiment = left_out_report::experiment(&name, scene, renderer);
                    recorder.record(stage, experiment.map_err(|error| error.to_string())?)?;
                }
            }
        }
    }
    for asked in &arguments.names {
        if !recorder.known.iter().any(|name| is_asked(asked, name)) {
            let known = recorder.known.join(", ");
            return Err(format!("there is no {asked}; there are {known}"));
        }
    }
    Ok(())
}

/// Whether an experiment such as `a04.sphere-far` is asked for, by its name or that of its stage.
fn is_asked(asked: &str, name: &str) -> bool {
    let stage = name.split('.').next().unwrap_or_default();
    asked == name || asked == stage
}

struct Recorder<'a> {
    arguments: &'a Arguments,
    /// The names of all experiments.
    known: Vec<String>,
}

impl Recorder<'_> {
    /// Measures an experiment, if it is asked for.
    fn record(&mut self, stage: &str, experiment: Experiment) -> Result<(), String> {
        let short = stage.split('-').next().unwrap_or_default();
        let name = format!("{short}.{}", experiment.name);
        let asked = &self.arguments.names;
        if asked.is_empty() || asked.iter().any(|asked| is_asked(asked, &name)) {
            let start = Instant::now();
            let file = format!("{}.csv", experiment.name);
            let file = self.arguments.folder.join(stage).join(file);
            measure(experiment, &file, self.arguments)?;
            println!("{:6.1} s  {name}", start.elapsed().as_secs_f64());
        }
        self.known.push(name);
        Ok(())
    }
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

/// Name and version of the compiler, which has just built this program.
fn compiler() -> String {
    let printed = Command::new("rustc").arg("--version").output();
    let printed = printed.map(|output| output.stdout).unwrap_or_default();
    let words = String::from_utf8_lossy(&printed);
    let words: Vec<_> = words.split_whitespace().take(2).collect();
    words.join(" ")
}

/// Measures an experiment, and writes it into its file.
fn measure(experiment: Experiment, file: &Path, arguments: &Arguments) -> Result<(), String> {
    let mut measured = Measured::in_rounds(experiment, Effort::Quick, ROUNDS, |_, _| {});
    measured.provenance.machine += ", ";
    measured.provenance.machine += &arguments.conditions;
    measured.provenance.version += ", ";
    measured.provenance.version += &compiler();
    let earlier = match fs::read_to_string(file) {
        Ok(text) => text,
        Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
        Err(error) => return Err(format!("{}: {error}", file.display())),
    };
    // A file of another form is replaced.
    if let Ok(earlier) = Measured::parse(&earlier)
        && !arguments.afresh
    {
        measured.keep(&earlier);
    }
    if let Some(folder) = file.parent() {
        fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    atomic_file::write(file, measured.csv().as_bytes()).map_err(|error| error.to_string())
}
