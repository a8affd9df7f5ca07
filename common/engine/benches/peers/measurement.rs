//! Measures the tracers in turn, and formats their figures as a row.

use std::io;
use std::time::Duration;

use crate::child;
use crate::difference::Difference;
use crate::tracer::{Job, Times, Tracer};

/// The best of a tracer.
pub struct Measurement {
    times: Times,
    /// The most memory, in bytes.
    peak: u64,
}

/// Lets all tracers render in turn, round after round. A tracer that is not installed,
/// fails or takes longer than `limit` has no measurement.
pub fn measure<const N: usize>(
    tracers: [&dyn Tracer; N],
    job: &Job,
    rounds: u32,
    limit: Duration,
) -> io::Result<[Option<Measurement>; N]> {
    let mut installed = tracers.map(Tracer::installed);
    for (tracer, _) in tracers
        .iter()
        .zip(installed)
        .filter(|(_, installed)| *installed)
    {
        tracer.write_scene(job)?;
    }
    let mut best = [const { None }; N];
    for _ in 0..rounds {
        for ((tracer, best), installed) in tracers.iter().zip(&mut best).zip(&mut installed) {
            if *installed {
                let now = render(*tracer, job, limit)?;
                *installed = now.is_some();
                *best = merge(best.take(), now);
            }
        }
    }
    Ok(best)
}

fn render(tracer: &dyn Tracer, job: &Job, limit: Duration) -> io::Result<Option<Measurement>> {
    let (mut command, log) = (tracer.command(job), job.file(tracer, "log"));
    let Some(outcome) = child::run(&mut command, &log, limit)? else {
        let (name, scene) = (tracer.name(), job.description.name);
        eprintln!("{scene}: {name} was stopped after {} s", limit.as_secs());
        return Ok(None);
    };
    let times = tracer.times(&outcome.log);
    if times.is_none() {
        eprintln!("{} failed; see {}", tracer.name(), log.display());
    }
    let peak = outcome.peak;
    Ok(times.map(|times| Measurement { times, peak }))
}

/// The shortest times and the greatest peak.
fn merge(a: Option<Measurement>, b: Option<Measurement>) -> Option<Measurement> {
    let (Some(a), Some(b)) = (&a, &b) else {
        return a.or(b);
    };
    Some(Measurement {
        times: Times {
            build: a.times.build.min(b.times.build),
            trace: a.times.trace.min(b.times.trace),
        },
        peak: a.peak.max(b.peak),
    })
}

/// The names of the cells of a [`row`].
pub const HEADER: &str = "\
|       |         |   trace |  times as long    |  peak | times as much     | build |   build |   build | different > 8 (mean of 255)       |
| scene | threads | ours ms | POV-Ray | Tachyon |   MiB | POV-Ray | Tachyon |    ms | POV-Ray | Tachyon |         POV-Ray |         Tachyon |
|-------|---------|---------|---------|---------|-------|---------|---------|-------|---------|---------|-----------------|-----------------|";

/// Our figures, and how many times as much the two others take.
pub fn row(tracers: [&dyn Tracer; 3], job: &Job, measured: &[Option<Measurement>; 3]) -> String {
    let figure = |i: usize, of: fn(&Measurement) -> f64| measured[i].as_ref().map(of);
    let ratio = |i, of| Some(figure(i, of)? / figure(0, of)?);
    let difference = |i: usize| {
        measured[0].as_ref().and(measured[i].as_ref())?;
        let [ours, theirs] = [tracers[0], tracers[i]].map(|tracer| job.file(tracer, "png"));
        Difference::between(&ours, &theirs).ok()
    };
    // About three digits, whether small or large.
    let number = |number: Option<f64>| match number {
        Some(number) if !number.is_finite() => "-".to_owned(),
        None => "-".to_owned(),
        Some(number) if number >= 100.0 => format!("{number:.0}"),
        Some(number) if number >= 0.1 || number == 0.0 => format!("{number:.2}"),
        Some(number) => format!("{number:.4}"),
    };
    let text = |difference: Option<Difference>| {
        difference.map_or("-".to_owned(), |difference| difference.to_string())
    };
    let trace: fn(&Measurement) -> f64 = |m| 1e3 * m.times.trace;
    let build: fn(&Measurement) -> f64 = |m| 1e3 * m.times.build;
    let peak: fn(&Measurement) -> f64 = |m| m.peak as f64 / f64::from(1 << 20);
    format!(
        "| {:>5} | {:>7} | {:>7} | {:>7} | {:>7} | {:>5} | {:>7} | {:>7} | {:>5} | {:>7} | {:>7} | {:>15} | {:>15} |",
        job.description.name,
        job.threads,
        number(figure(0, trace)),
        number(ratio(1, trace)),
        number(ratio(2, trace)),
        number(figure(0, peak)),
        number(ratio(1, peak)),
        number(ratio(2, peak)),
        number(figure(0, build)),
        number(figure(1, build)),
        number(figure(2, build)),
        text(difference(1)),
        text(difference(2)),
    )
}
