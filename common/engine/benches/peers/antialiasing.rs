//! Smooth edges: how near each program comes to its own picture of 1,024 samples a
//! pixel, and in which time.
//!
//! The error that nobody sees, 1/510, is 0.50 of 255. Rounding a picture to bytes
//! has 0.29 of its own where colours change smoothly, which counts here. The fastest
//! setting that stays below is compared, or below POV-Ray's smallest error where that is
//! larger: POV-Ray's settings name no error, and ours mostly make a smaller one than the
//! bound that they name.
//!
//! The times are those on the processor, so that other programs do not count.
//!
//! Each is measured against itself, so that nothing else that differs counts.
//! Tachyon is left out: it takes equally many samples in every pixel, at random.

use std::error::Error;
use std::ops::Add;
use std::path::Path;
use std::time::Duration;

use common::{Color, Image, Size, picture_file};
use measure::experiment::HALF_GREY_LEVEL;

use crate::child::{self, Outcome};
use crate::description::Description;
use crate::ours::Ours;
use crate::povray::PovRay;
use crate::tracer::{Job, Tracer};

/// A program, how it renders its reference, and ways to take fewer samples.
struct Contestant {
    tracer: &'static dyn Tracer,
    reference: &'static str,
    /// Width and height of the reference, in those of the picture: the mean of a square of
    /// its pixels is one pixel. It is 1 where possible, as each pixel of a file is cut off
    /// at white, also the ones of a highlight that is smaller than a pixel of the picture.
    finer: u32,
    variants: &'static [&'static str],
}

/// POV-Ray's `+AM1` takes n x n samples (`+Rn`) where neighbouring pixels differ
/// by more than `+A`; `+AM2` divides pixels, up to n times, where their corners
/// differ. `-J` moves no sample at random.
const CONTESTANTS: [Contestant; 2] = [
    Contestant {
        tracer: &Ours,
        reference: "--samples 1024 --sampling regular",
        finer: 1,
        variants: &[
            "--samples 1",
            "--samples 4 --sampling regular",
            "--samples 9 --sampling regular",
            "--samples 16 --sampling regular",
            "--max-error 0.0015 --samples 1024",
            "--max-error 0.00196 --samples 1024",
            "--max-error 0.0025 --samples 1024",
            "--max-error 0.003 --samples 1024",
            "--max-error 0.0035 --samples 1024",
            "--max-error 0.004 --samples 1024",
            "--max-error 0.005 --samples 1024",
            "--max-error 0.006 --samples 1024",
            "--max-error 0.007 --samples 1024",
            "--max-error 0.008 --samples 1024",
            "--max-error 0.01 --samples 1024",
            "--max-error 0.012 --samples 1024",
            "--max-error 0.015 --samples 1024",
            "--max-error 0.02 --samples 1024",
            "--max-error 0.03 --samples 1024",
            "--max-error 0.04 --samples 1024",
            "--max-error 0.05 --samples 1024",
        ],
    },
    Contestant {
        tracer: &PovRay,
        // It takes at most 81 samples.
        reference: "+A0.0 +AM1 +R8 -J",
        finer: 4,
        variants: &[
            "-A",
            "+A0.5 +AM1 +R2 -J",
            "+A0.5 +AM1 +R3 -J",
            "+A0.3 +AM1 +R2 -J",
            "+A0.3 +AM1 +R3 -J",
            "+A0.3 +AM2 +R2 -J",
            "+A0.2 +AM1 +R3 -J",
            "+A0.2 +AM2 +R2 -J",
            "+A0.17 +AM1 +R3 -J",
            "+A0.15 +AM1 +R3 -J",
            "+A0.14 +AM1 +R3 -J",
            "+A0.12 +AM1 +R3 -J",
            "+A0.15 +AM2 +R2 -J",
            "+A0.1 +AM1 +R2 -J",
            "+A0.1 +AM1 +R3 -J",
            "+A0.1 +AM1 +R4 -J",
            "+A0.1 +AM2 +R2 -J",
            "+A0.1 +AM2 +R3 -J",
            "+A0.05 +AM1 +R3 -J",
            "+A0.05 +AM1 +R4 -J",
            "+A0.05 +AM2 +R2 -J",
            "+A0.05 +AM2 +R3 -J",
            "+A0.03 +AM1 +R5 -J",
            "+A0.01 +AM1 +R5 -J",
            "+A0.01 +AM2 +R4 -J",
        ],
    },
];

/// Nobody sees a smaller error, of 255.
const INVISIBLE: f64 = 255.0 * HALF_GREY_LEVEL;

/// How long a program took in one of these ways, at least, and how far off it was.
struct Row {
    tracer: &'static dyn Tracer,
    arguments: &'static str,
    seconds: f64,
    error: f64,
}

/// Prints a table of the programs that take part, and their ways, for each scene, and how the
/// fastest ways to an error that nobody sees compare.
pub fn compare(
    descriptions: &[Description],
    folder: &Path,
    size: Size,
    rounds: u32,
    limit: Duration,
    takes_part: &dyn Fn(&dyn Tracer) -> bool,
) -> Result<(), Box<dyn Error>> {
    println!("| scene | program | samples                            | trace ms | error of 255 |");
    println!("|-------|---------|------------------------------------|----------|--------------|");
    for description in descriptions {
        let name = description.name;
        let rows = rows(description, folder, size, rounds, limit, takes_part)?;
        for row in &rows {
            let (program, arguments) = (row.tracer.name(), row.arguments);
            let (time, error) = (1e3 * row.seconds, row.error);
            println!(
                "| {name:>5} | {program:<7} | {arguments:<34} | {time:>8.1} | {error:>12.2} |"
            );
        }
        let of = |program: &'static str| rows.iter().filter(move |r| r.tracer.name() == program);
        let errors = of(PovRay.name()).map(|row| row.error);
        let limit = errors.min_by(f64::total_cmp).unwrap_or(0.0).max(INVISIBLE);
        let fastest = |program| {
            let good = of(program).filter(|row| row.error <= limit);
            good.map(|row| row.seconds).min_by(f64::total_cmp)
        };
        if let (Some(other), Some(ours)) = (fastest(PovRay.name()), fastest(Ours.name())) {
            let ratio = other / ours;
            println!("{name}: up to {limit:.2}, POV-Ray takes {ratio:.1} times as long");
        }
    }
    Ok(())
}

/// The programs take turns, so that all have the same share of a machine that is faster
/// at times.
fn rows(
    description: &Description,
    folder: &Path,
    size: Size,
    rounds: u32,
    limit: Duration,
    takes_part: &dyn Fn(&dyn Tracer) -> bool,
) -> Result<Vec<Row>, Box<dyn Error>> {
    let job = |size| Job {
        description,
        folder,
        size,
        threads: 1,
    };
    let mut contestants = Vec::new();
    for contestant in CONTESTANTS.iter().filter(|c| takes_part(c.tracer)) {
        let [width, height] = [size.width(), size.height()].map(|side| contestant.finer * side);
        let fine = job(Size::new(width, height)?);
        if let Some(reference) = reference(contestant, &fine, limit)? {
            contestant.tracer.write_scene(&job(size))?;
            contestants.push((contestant, reference));
        }
    }
    let job = job(size);
    let most = contestants.iter().map(|(c, _)| c.variants.len()).max();
    let mut rows: Vec<Row> = Vec::new();
    for _ in 0..rounds {
        for i in 0..most.unwrap_or(0) {
            for (contestant, reference) in &contestants {
                let tracer = contestant.tracer;
                let Some(arguments) = contestant.variants.get(i) else {
                    continue;
                };
                let Some(seconds) = trace(tracer, &job, arguments, limit)? else {
                    continue;
                };
                let same = |row: &&mut Row| row.arguments == *arguments;
                if let Some(row) = rows.iter_mut().find(same) {
                    row.seconds = row.seconds.min(seconds);
                    continue;
                }
                let picture = picture_file::open(&job.file(tracer, "png"))?;
                rows.push(Row {
                    tracer,
                    arguments,
                    seconds,
                    error: difference(&picture, reference),
                });
            }
        }
    }
    rows.sort_by_key(|row| row.tracer.name());
    Ok(rows)
}

/// The picture of 1,024 samples a pixel.
fn reference(
    contestant: &Contestant,
    fine: &Job,
    limit: Duration,
) -> Result<Option<Image>, Box<dyn Error>> {
    let tracer = contestant.tracer;
    tracer.write_scene(fine)?;
    if trace(tracer, fine, contestant.reference, limit)?.is_none() {
        return Ok(None);
    }
    let large = picture_file::open(&fine.file(tracer, "png"))?;
    let side = contestant.finer;
    let size = Size::new(fine.size.width() / side, fine.size.height() / side)?;
    let mean = |x, y| {
        let offsets = (0..side * side).map(|i| (i % side, i / side));
        let pixels = offsets.map(|(dx, dy)| large.get(side * x + dx, side * y + dy));
        let sum = pixels
            .map(Option::unwrap_or_default)
            .fold(Color::BLACK, Color::add);
        sum * (1.0 / f64::from(side * side))
    };
    Ok(Some(Image::from_fn(size, mean)?))
}

/// The seconds that a program traces with these additional arguments: on a processor, if
/// its log names them.
fn trace(
    tracer: &dyn Tracer,
    job: &Job,
    arguments: &str,
    limit: Duration,
) -> Result<Option<f64>, Box<dyn Error>> {
    let mut command = tracer.command(job);
    command.args(arguments.split_whitespace());
    let outcome = child::run(&mut command, &job.file(tracer, "log"), limit)?;
    let seconds = outcome.and_then(|Outcome { log, .. }| {
        let trace = tracer.times(&log)?.trace;
        Some(processor_seconds(&log).unwrap_or(trace))
    });
    if seconds.is_none() {
        eprintln!("{}: nothing came of {arguments}", tracer.name());
    }
    Ok(seconds)
}

/// The time on a processor in the last line that names one, without the time in which other
/// programs had it.
fn processor_seconds(log: &str) -> Option<f64> {
    let (before, _) = log.rsplit_once(" CPU-seconds")?;
    before.rsplit(' ').next()?.parse().ok()
}

/// The root of the mean square difference of all channels, of 255.
fn difference(a: &Image, b: &Image) -> f64 {
    let pixels = a.pixels().iter().zip(b.pixels());
    let squares: f64 = pixels
        .flat_map(|(a, b)| (*a - *b).channels())
        .map(|difference| difference * difference)
        .sum();
    255.0 * (squares / (3.0 * a.size().pixels() as f64)).sqrt()
}
