//! Measures the tracers in turn, and compares their figures.

use std::io::{self, ErrorKind};
use std::time::Duration;

use crate::child;
use crate::description::Description;
use crate::difference::Difference;
use crate::tracer::{Job, Times, Tracer};

/// The best figures of a tracer, in seconds and bytes.
#[derive(Clone, Copy)]
pub struct Measurement {
    pub build: f64,
    pub trace: f64,
    /// Of one round: both together.
    pub total: f64,
    pub peak: f64,
}

/// One of the figures.
pub type Figure = fn(&Measurement) -> f64;

/// A scene rendered by all tracers on a number of threads.
pub struct Comparison<'a> {
    pub description: &'a Description,
    pub threads: u16,
    /// Ours first; none of a tracer that is not installed, fails, cannot express the
    /// scene or takes too long.
    pub measured: [Option<Measurement>; 3],
    /// From our picture.
    pub differences: [Option<Difference>; 3],
}

impl Comparison<'_> {
    pub fn figure(&self, tracer: usize, of: Figure) -> Option<f64> {
        self.measured[tracer].as_ref().map(of)
    }

    /// How many times our figure another tracer's is.
    pub fn ratio(&self, tracer: usize, of: Figure) -> Option<f64> {
        Some(self.figure(tracer, of)? / self.figure(0, of)?)
    }
}

/// Lets all tracers that are present do all jobs in turn, round after round.
pub fn compare<'a>(
    tracers: [&dyn Tracer; 3],
    present: [bool; 3],
    jobs: &[Job<'a>],
    rounds: u32,
    limit: Duration,
) -> io::Result<Vec<Comparison<'a>>> {
    let mut takes_part = vec![present; jobs.len()];
    for (job, takes_part) in jobs.iter().zip(&mut takes_part) {
        for (tracer, takes_part) in tracers.iter().zip(takes_part) {
            *takes_part = *takes_part && can_express(*tracer, job)?;
        }
    }
    let mut measured = vec![[None; 3]; jobs.len()];
    for _ in 0..rounds {
        for (i, job) in jobs.iter().enumerate() {
            for (j, tracer) in tracers.iter().enumerate() {
                if takes_part[i][j] {
                    let now = render(*tracer, job, limit)?;
                    takes_part[i][j] = now.is_some();
                    measured[i][j] = merge(measured[i][j], now);
                }
            }
        }
    }
    let comparisons = jobs.iter().zip(measured).map(|(job, measured)| {
        let [ours, ..] = tracers.map(|tracer| job.file(tracer, "png"));
        let difference = |i: usize| {
            measured[0].and(measured[i])?;
            Difference::between(&ours, &job.file(tracers[i], "png")).ok()
        };
        Comparison {
            description: job.description,
            threads: job.threads,
            measured,
            differences: [0, 1, 2].map(difference),
        }
    });
    Ok(comparisons.collect())
}

fn can_express(tracer: &dyn Tracer, job: &Job) -> io::Result<bool> {
    match tracer.write_scene(job) {
        Err(error) if error.kind() == ErrorKind::Unsupported => Ok(false),
        written => written.map(|()| true),
    }
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
    Ok(times.map(|Times { build, trace }| Measurement {
        build,
        trace,
        total: build + trace,
        peak: outcome.peak as f64,
    }))
}

/// The shortest times and the greatest peak.
fn merge(a: Option<Measurement>, b: Option<Measurement>) -> Option<Measurement> {
    let (Some(a), Some(b)) = (a, b) else {
        return a.or(b);
    };
    Some(Measurement {
        build: a.build.min(b.build),
        trace: a.trace.min(b.trace),
        total: a.total.min(b.total),
        peak: a.peak.max(b.peak),
    })
}
