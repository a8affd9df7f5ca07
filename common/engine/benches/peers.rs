//! The engine beside the ray tracers that a student could install.
//!
//! ```console
//! $ apt-get install povray tachyon
//! $ cargo bench -p engine --bench peers                   all scenes
//! $ cargo bench -p engine --bench peers -- s1 s3 --quick  two of them, one round
//! ```
//!
//! Where a program is missing, its columns stay empty. `--help` lists what can
//! be changed. Scenes, pictures and logs stay in `target/tmp/peers/`.
//!
//! | scene | what is in it |
//! |---|---|
//! | s1 | nine spheres on a plane, all mirroring half, eight deep |
//! | s2 | the course's four objects, matt, under a far light |
//! | s3 | 1,000 shiny spheres |
//! | s4 | a torus of 20,000 smooth triangles |
//! | s5 | 100,000 small shiny spheres |
//!
//! All three programs take one sample in the middle of each pixel, and cast a
//! shadow ray wherever the one light may shine: Tachyon has no light without
//! shadows. No scene has a background other than black, coloured highlights or
//! coloured mirrors, because one of the programs cannot express them.
//!
//! The programs run with their default options, apart from those that make their
//! pictures equal. They take turns, and of all rounds the shortest time counts. Times
//! are the ones that each program prints about itself: tracing without reading
//! the scene and writing the file, and building the structures that make tracing
//! fast; for the engine that includes making its scene. (POV-Ray builds the
//! structure of a mesh while it reads, so that its time is in neither column.)
//! Memory is the peak of the whole process, seen from outside. Ratios say how
//! many times as long, or as much, the other program takes: above 1 ours is
//! better. The last columns say which share of pixels differs from ours by more
//! than 8 of 255, and the mean difference, so that nobody compares different
//! work.
//!
//! `aa`, with the names of scenes or without, compares ways to smooth edges
//! instead: the trace time and the error against 256 samples a pixel.

#[path = "peers/antialiasing.rs"]
mod antialiasing;
#[path = "peers/camera.rs"]
mod camera;
#[path = "peers/child.rs"]
mod child;
#[path = "peers/description.rs"]
mod description;
#[path = "peers/difference.rs"]
mod difference;
#[path = "peers/measurement.rs"]
mod measurement;
#[path = "peers/ours.rs"]
mod ours;
#[path = "peers/povray.rs"]
mod povray;
#[path = "../src/adaptive/random.rs"]
mod random;
#[path = "peers/samples.rs"]
mod samples;
#[path = "peers/scenes.rs"]
mod scenes;
#[path = "peers/tachyon.rs"]
mod tachyon;
#[path = "peers/tracer.rs"]
mod tracer;

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use clap::Parser;
use common::{Sampling, Settings, Size};
use program::by_name;

use crate::description::Description;
use crate::measurement::{HEADER, measure, row};
use crate::ours::Ours;
use crate::povray::PovRay;
use crate::tachyon::Tachyon;
use crate::tracer::{Job, Tracer};

/// Compares the engine with POV-Ray and Tachyon.
#[derive(Parser)]
struct Options {
    /// The scenes to render; all if none is named. "aa" smooths their edges.
    scenes: Vec<String>,
    /// How often each program renders each scene; the shortest time counts.
    #[arg(long, default_value_t = 3)]
    rounds: u32,
    /// One round only.
    #[arg(long)]
    quick: bool,
    /// Numbers of threads, each for itself.
    #[arg(long, value_delimiter = ',', default_value = "1,2")]
    #[arg(value_parser = clap::value_parser!(u16).range(1..))]
    threads: Vec<u16>,
    /// Width and height of the pictures.
    #[arg(long, default_value = "1280x960")]
    size: Size,
    /// Seconds after which a rendering is given up.
    #[arg(long, default_value_t = 120)]
    limit: u64,
    /// Render one scene with the engine; the benchmark calls itself with it.
    #[arg(long, hide = true, requires = "output")]
    render: Option<String>,
    /// Samples per pixel of `--render`.
    #[arg(long, hide = true, default_value_t = 1)]
    samples: u32,
    /// Where the samples of `--render` lie.
    #[arg(long, hide = true, default_value = "center", value_parser = by_name::<Sampling>())]
    sampling: Sampling,
    /// The error that `--render` may have; it then takes at most the samples.
    #[arg(long, hide = true)]
    max_error: Option<f64>,
    /// The picture file of `--render`.
    #[arg(short, hide = true)]
    output: Option<PathBuf>,
    /// Given by `cargo bench`, but not by `cargo test`, which is to render nothing.
    #[arg(long, hide = true)]
    bench: bool,
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    if let (Some(scene), Some(path)) = (&options.render, &options.output) {
        let threads = options.threads.first().copied().unwrap_or(1);
        let description = &named(std::slice::from_ref(scene))?[0];
        let settings = Settings {
            size: options.size,
            samples: options.samples,
            sampling: options.sampling,
            max_error: options.max_error,
            ..Settings::default()
        };
        ours::render_to(description, &settings, threads, path)
    } else if options.bench {
        compare(options)
    } else {
        Ok(())
    }
}

/// The descriptions of these names; all if there are none.
fn named(names: &[String]) -> Result<Vec<Description>, Box<dyn Error>> {
    let mut all = scenes::all();
    if let Some(unknown) = names
        .iter()
        .find(|name| all.iter().all(|s| s.name != **name))
    {
        let known: Vec<_> = all.iter().map(|scene| scene.name).collect();
        return Err(format!(
            "there is no scene \"{unknown}\"; there are {}",
            known.join(", ")
        )
        .into());
    }
    all.retain(|scene| names.is_empty() || names.iter().any(|name| name == scene.name));
    Ok(all)
}

/// Prints a row for each scene and number of threads.
fn compare(options: &Options) -> Result<(), Box<dyn Error>> {
    let (smooth, names): (Vec<_>, Vec<_>) = options
        .scenes
        .iter()
        .cloned()
        .partition(|name| name == "aa");
    let descriptions = named(&names)?;
    let tracers: [&dyn Tracer; 3] = [&Ours, &PovRay, &Tachyon];
    for missing in tracers.iter().filter(|tracer| !tracer.installed()) {
        eprintln!(
            "{} is not installed: its figures are left out",
            missing.name()
        );
    }
    let folder = &Path::new(env!("CARGO_TARGET_TMPDIR")).join("peers");
    fs::create_dir_all(folder)?;
    let (size, limit) = (options.size, Duration::from_secs(options.limit));
    let rounds = if options.quick {
        1
    } else {
        options.rounds.max(1)
    };
    if !smooth.is_empty() {
        return antialiasing::compare(&descriptions, folder, size, rounds, limit);
    }

    println!("{HEADER}");
    for description in &descriptions {
        for &threads in &options.threads {
            let job = Job {
                description,
                folder,
                size,
                threads,
            };
            let measured = measure(tracers, &job, rounds, limit)?;
            println!("{}", row(tracers, &job, &measured));
        }
    }
    Ok(())
}
