//! The engine beside the ray tracers that a student could install.
//!
//! ```sh
//! apt-get install povray tachyon time
//! cargo bench -p a03-lab --bench peers
//! ```
//!
//! Behind `--`, `hills nodes --size 640x480` takes two scenes, small, and `--alone --rounds 20` measures
//! the gain of the second thread. `embree.py` beside this file counts rays of Embree, which has single
//! precision and no pictures.
//!
//! The columns of a missing program have no numbers, nor those of Tachyon in the scene
//! `nodes`, because it has none. Scenes and pictures stay in `target/tmp/peers/`.
//!
//! All programs take one sample in the middle of each pixel, and cast a shadow ray wherever
//! a light may shine. They run with their default options, apart from those that make their
//! pictures equal. They take turns, and of all rounds the shortest time counts. Times are the
//! ones that each program prints about itself. Building makes the structures for rays that
//! depend on the objects alone; for the engine that includes making its scene. Tracing is the
//! rest, without reading the scene and writing the file. (POV-Ray builds the structure of a
//! mesh while it reads, so that its time is in no column.) Memory is the peak of the process.

mod program;
mod report;
#[path = "../support/mod.rs"]
mod support;
mod written;

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Parser;
use common::{Settings, Size, Transfer, picture_file};
use rayon::ThreadPoolBuilder;

use crate::program::{Figures, OfPrograms, PROGRAMS};
use crate::support::Grid;
use crate::support::scene::{SCENES, Scene};

/// Compares the engine with POV-Ray and Tachyon.
#[derive(Parser)]
struct Options {
    /// The scenes to render; all if none is named.
    scenes: Vec<String>,
    /// How often each program renders each scene; the shortest time counts.
    #[arg(long, default_value_t = 3)]
    rounds: u32,
    /// Leave out the other programs.
    #[arg(long)]
    alone: bool,
    /// Numbers of threads, each for itself.
    #[arg(long, value_delimiter = ',', default_value = "1,2")]
    threads: Vec<u16>,
    /// Width and height of the pictures.
    #[arg(long, default_value = "1280x960")]
    size: Size,
    /// Render one scene into this file with the engine; the benchmark calls itself with it.
    #[arg(long, hide = true)]
    render: Option<PathBuf>,
    /// Given by `cargo bench`, but not by `cargo test`, which is to render nothing.
    #[arg(long, hide = true)]
    bench: bool,
}

type Outcome = Result<(), Box<dyn Error>>;

fn main() -> Outcome {
    let options = Options::parse();
    let scenes = chosen(&options.scenes)?;
    match &options.render {
        Some(file) => render(scenes[0], options.size, options.threads[0], file),
        None if options.bench => compare(&options, &scenes),
        None => Ok(()),
    }
}

/// The scenes with these names; without a name, all scenes.
fn chosen(names: &[String]) -> Result<Vec<&'static Scene>, Box<dyn Error>> {
    let mut scenes: Vec<&Scene> = SCENES.iter().collect();
    if names.is_empty() {
        return Ok(scenes);
    }
    let known: Vec<_> = scenes.iter().map(|scene| scene.name).collect();
    scenes.retain(|scene| names.iter().any(|name| name == scene.name));
    if scenes.len() < names.len() {
        return Err(format!("the scenes are {}", known.join(", ")).into());
    }
    Ok(scenes)
}

/// Prints a row for each scene, with the least figures of all rounds.
fn compare(options: &Options, scenes: &[&'static Scene]) -> Outcome {
    fs::create_dir_all(program::folder())?;
    report::head();
    for scene in scenes {
        report::row(scene, &least_figures(options, scene)?);
    }
    Ok(())
}

/// The least figures of all programs for a scene, on each number of threads. The programs take
/// turns.
fn least_figures(options: &Options, scene: &Scene) -> Result<Vec<OfPrograms>, Box<dyn Error>> {
    let size = options.size;
    let candidates = if options.alone { 1 } else { PROGRAMS.len() };
    let mut able = Vec::new();
    for (i, program) in PROGRAMS[..candidates].iter().enumerate() {
        match program.write(scene, size) {
            Ok(()) => able.push((i, program)),
            Err(error) => eprintln!("{}, {}: {error}", scene.name, program.name),
        }
    }
    let mut least = vec![[Figures::NONE; PROGRAMS.len()]; options.threads.len()];
    for _ in 0..options.rounds {
        for (threads, least) in options.threads.iter().zip(&mut least) {
            for (i, program) in &able {
                let now = program.render(scene, size, *threads)?;
                least[*i] = least[*i].min(&now);
            }
        }
    }
    Ok(least)
}

/// Renders a scene into a file, with one sample in each pixel, and prints the times.
fn render(scene: &Scene, size: Size, threads: u16, file: &Path) -> Outcome {
    let settings = Settings {
        size,
        ..Settings::default()
    };
    let pool = ThreadPoolBuilder::new().num_threads(threads.into());
    let rgb = pool.build()?.install(|| {
        let started = Instant::now();
        let renderer = scene.prepare(&settings);
        println!("build: {} seconds", started.elapsed().as_secs_f64());

        let started = Instant::now();
        let image = renderer.render(&Grid { side: 1 }, &settings, &())?;
        let rgb = image.to_rgb8(Transfer::Linear);
        println!("trace: {} seconds", started.elapsed().as_secs_f64());
        Ok::<_, common::Error>(rgb)
    })?;
    Ok(picture_file::save_png(file, size, &rgb)?)
}
