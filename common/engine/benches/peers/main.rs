//! The engine beside the ray tracers that a student could install.
//!
//! ```console
//! $ apt-get install povray tachyon
//! $ cargo bench -p engine --bench peers                           all scenes
//! $ cargo bench -p engine --bench peers -- torus cloud --quick  two of them, small, one round
//! $ cargo bench -p engine --bench peers -- --alone --rounds 20  the gain of the second thread
//! ```
//!
//! Where a program is missing, its columns stay empty. `--help` lists the
//! options. Scenes, pictures and logs stay in `target/tmp/peers/`.
//!
//! All three programs take one sample in the middle of each pixel, and cast a
//! shadow ray wherever a light may shine: Tachyon has no light without shadows. No
//! scene has a background other than black, coloured highlights or coloured
//! mirrors, because one of the programs cannot express them. Tachyon has no node:
//! its cells of the scene `nodes` stay empty.
//!
//! The programs run with their default options, apart from those that make their
//! pictures equal. They take turns, and of all rounds the shortest time counts. Times
//! are the ones that each program prints about itself. Building makes the structures
//! for rays that depend on the objects alone, so that a second picture of the same
//! world would not need it again; for the engine that includes making its scene.
//! Tracing is the rest, without reading the scene and writing the file; all work that
//! depends on eye, lights or picture is part of it. The total is both together. (POV-Ray
//! builds the structure of a mesh while it reads, so that its time is in no column.)
//! Memory is the peak of the whole process, seen from outside. Ratios say how
//! many times as long, or as much, the other program takes: above 1 ours is
//! better. The last columns say which share of pixels differs from ours by more
//! than 8 of 255, and the mean difference, so that nobody compares different
//! work. Behind the table stand the targets, and the scenes that miss them.
//!
//! `--book` then prints the table of the book, and renews its small pictures.
//!
//! `aa`, with the names of scenes or without, compares ways to smooth edges
//! instead: the trace time and the error against 1,024 samples a pixel. POV-Ray takes
//! minutes for some of these references: `--limit 3600`.

mod antialiasing;
mod camera;
mod child;
mod description;
mod difference;
mod measurement;
mod ours;
mod povray;
#[path = "../../src/adaptive/random.rs"]
mod random;
mod samples;
mod scenes;
mod table;
mod tachyon;
mod targets;
mod tracer;

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use clap::Parser;
use common::{ArgumentError, Sampling, Settings, Size};
use program::{SAMPLINGS, by_name};

use crate::description::Description;
use crate::ours::Ours;
use crate::povray::PovRay;
use crate::tachyon::Tachyon;
use crate::tracer::{Job, Times, Tracer};

/// Compares the engine with POV-Ray and Tachyon.
#[derive(Parser)]
#[expect(clippy::struct_excessive_bools, reason = "independent flags")]
struct Options {
    /// The scenes to render; all if none is named. "aa" smooths their edges.
    scenes: Vec<String>,
    /// How often each program renders each scene; the shortest time counts.
    #[arg(long, default_value_t = 3)]
    rounds: u32,
    /// One round only, and smaller pictures.
    #[arg(long)]
    quick: bool,
    /// Leave out the other programs.
    #[arg(long)]
    alone: bool,
    /// Numbers of threads, each for itself.
    #[arg(long, value_delimiter = ',', default_value = "1,2")]
    #[arg(value_parser = clap::value_parser!(u16).range(1..))]
    threads: Vec<u16>,
    /// Width and height of the pictures: 1280x960, or 640x480 if they are to be quick.
    #[arg(long)]
    size: Option<Size>,
    /// Seconds after which a rendering is given up.
    #[arg(long, default_value_t = 120)]
    limit: u64,
    /// Print the table of the book, too, and renew its pictures of these scenes.
    #[arg(long)]
    book: bool,
    /// Render one scene with the engine; the benchmark calls itself with it.
    #[arg(long, hide = true, requires = "output")]
    render: Option<String>,
    /// Samples per pixel of `--render`.
    #[arg(long, hide = true, default_value_t = 1)]
    samples: u32,
    /// Where the samples of `--render` lie.
    #[arg(long, hide = true, default_value = "center", value_parser = by_name(SAMPLINGS))]
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

impl Options {
    fn size(&self) -> Result<Size, ArgumentError> {
        match self.size {
            Some(size) => Ok(size),
            None if self.quick => Size::new(640, 480),
            None => Size::new(1280, 960),
        }
    }
}

fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    if let (Some(scene), Some(path)) = (&options.render, &options.output) {
        let threads = options.threads.first().copied().unwrap_or(1);
        let description = &named(std::slice::from_ref(scene))?[0];
        let settings = Settings {
            size: options.size()?,
            samples: options.samples,
            sampling: options.sampling,
            max_error: options.max_error,
            ..Settings::default()
        };
        let Times { build, trace } = ours::render_to(description, &settings, threads, path)?;
        println!("build: {build} seconds\ntrace: {trace} seconds");
        Ok(())
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

/// Prints a row for each scene and number of threads, and then the targets.
fn compare(options: &Options) -> Result<(), Box<dyn Error>> {
    let (smooth, names): (Vec<_>, Vec<_>) = options
        .scenes
        .iter()
        .cloned()
        .partition(|name| name == "aa");
    let descriptions = named(&names)?;
    let tracers: [&dyn Tracer; 3] = [&Ours, &PovRay, &Tachyon];
    let is_wanted = |tracer: &dyn Tracer| !options.alone || tracer.name() == Ours.name();
    let takes_part = |tracer: &dyn Tracer| is_wanted(tracer) && tracer.installed();
    for missing in tracers {
        if is_wanted(missing) && !missing.installed() {
            let name = missing.name();
            eprintln!("{name} is not installed: its figures are left out");
        }
    }
    let folder = &Path::new(env!("CARGO_TARGET_TMPDIR")).join("peers");
    fs::create_dir_all(folder)?;
    let (size, limit) = (options.size()?, Duration::from_secs(options.limit));
    let rounds = if options.quick {
        1
    } else {
        options.rounds.max(1)
    };
    if !smooth.is_empty() {
        return antialiasing::compare(&descriptions, folder, size, rounds, limit, &takes_part);
    }

    let present = tracers.map(takes_part);
    println!("{}", table::HEADER);
    let mut comparisons = Vec::new();
    for description in &descriptions {
        let job = |&threads| Job {
            description,
            folder,
            size,
            threads,
        };
        let jobs: Vec<_> = options.threads.iter().map(job).collect();
        for comparison in measurement::compare(tracers, present, &jobs, rounds, limit)? {
            println!("{}", table::row(&comparison));
            comparisons.push(comparison);
        }
    }
    println!("\n{}", targets::summary(&comparisons));
    if options.book {
        println!("{}", table::of_book(&comparisons));
        small_pictures(&descriptions)?;
    }
    Ok(())
}

/// Renews the pictures of the book.
fn small_pictures(descriptions: &[Description]) -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src/pictures");
    let settings = Settings {
        size: Size::new(144, 108)?,
        samples: 16,
        sampling: Sampling::Regular,
        ..Settings::default()
    };
    for description in descriptions {
        let file = format!("peers-{}.png", description.name);
        ours::render_to(description, &settings, 1, &folder.join(file))?;
    }
    Ok(())
}
