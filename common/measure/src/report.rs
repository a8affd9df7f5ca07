//! The report of an experiment: table, CSV and plots.

mod csv;
mod parse;
mod table;

use std::path::{Path, PathBuf};

use common::{Error, Median, atomic_file};

use crate::experiment::{Curve, Curves, Experiment};
use crate::front::EQUAL_TIMES;
use crate::provenance::Provenance;
use crate::{Effort, plot};

pub use parse::NotRecorded;
pub(crate) use table::compact;

/// An experiment with its errors and times.
pub struct Measured<'a> {
    /// The experiment.
    pub experiment: Experiment<'a>,
    /// The methods with their errors and times.
    pub curves: Vec<Curve<'a>>,
    /// The machine and the build.
    pub provenance: Provenance,
}

/// The least processor time of a measurement in seconds, for which short runs are repeated.
const LEAST_TIME: f64 = 1e-3;

/// The fewest rounds, and the processor time in seconds that is enough for all rounds of an experiment.
const FEWEST_ROUNDS: usize = 9;
const ENOUGH_TIME: f64 = 6.0;

/// The most runs of a measurement.
const MOST_RUNS: f64 = 1e4;

impl<'a> Measured<'a> {
    /// Measures errors, then times, in 9 rounds or 15 of full effort.
    ///
    /// Calls `progress` with the number of measured times and their total, before
    /// the first measurement and after each.
    pub fn new(
        experiment: Experiment<'a>,
        effort: Effort,
        progress: impl FnMut(usize, usize),
    ) -> Self {
        Self::in_rounds(experiment, effort, effort.choose(9, 15), progress)
    }

    /// Measures errors, then times in a number of rounds, or in fewer if these take long. In each round
    /// all methods take turns at each value of the parameter, so that other load on the machine affects
    /// them equally.
    pub fn in_rounds(
        experiment: Experiment<'a>,
        effort: Effort,
        rounds: usize,
        mut progress: impl FnMut(usize, usize),
    ) -> Self {
        let mut curves = (experiment.curves)(effort);
        let longest = curves.iter().map(|curve| curve.points.len()).max();
        let longest = longest.unwrap_or(0);
        let mut times = Vec::new();
        for curve in &mut curves {
            let unmeasured = PointTimes::default;
            times.push(vec![unmeasured(); curve.points.len()]);
        }
        let points: usize = times.iter().map(Vec::len).sum();
        let (mut done, all) = (0, rounds * points);
        progress(done, all);
        let (mut measured_rounds, mut total) = (0, 0.0);
        for round in 0..rounds {
            if round >= FEWEST_ROUNDS && total > ENOUGH_TIME {
                break;
            }
            measured_rounds += 1;
            for p in 0..longest {
                for turn in 0..curves.len() {
                    // Another one begins each time, because the first may find caches empty.
                    let c = (turn + round) % curves.len();
                    let Some(point) = curves[c].points.get_mut(p) else {
                        continue;
                    };
                    let times = &mut times[c][p];
                    if round == 0 {
                        // The first run fills caches, and says how many runs take long enough.
                        let first = point.times.measure(1).max(1e-9);
                        times.runs = (LEAST_TIME / first).clamp(1.0, MOST_RUNS) as u32;
                    }
                    let seconds = point.times.measure(times.runs);
                    total += seconds * f64::from(times.runs);
                    times.seconds.push(seconds);
                    done += 1;
                    progress(done, all);
                }
            }
        }
        for (c, of_curve) in times.iter().enumerate() {
            for (p, own) in of_curve.iter().enumerate() {
                let over_first = shares_parameter(&experiment, &curves, c, p)
                    .then(|| Median::of_quotients(&own.seconds, &times[0][p].seconds));
                let point = &mut curves[c].points[p];
                point.times.seconds = Median::of(own.seconds.clone());
                point.times.over_first = over_first;
            }
        }
        let mut measured = Self {
            experiment,
            curves,
            provenance: Provenance::here(measured_rounds),
        };
        measured.derive_seconds();
        measured
    }

    /// The times of all methods but the first follow from those of the first and the quotients, so
    /// that times and quotients say the same.
    fn derive_seconds(&mut self) {
        let Some((first, others)) = self.curves.split_first_mut() else {
            return;
        };
        for curve in others {
            for (point, of_first) in curve.points.iter_mut().zip(&first.points) {
                if let Some(Median { low, value, high }) = point.times.over_first {
                    let unit = of_first.times.seconds.value;
                    point.times.seconds = Median {
                        low: low * unit,
                        value: value * unit,
                        high: high * unit,
                    };
                }
            }
        }
    }

    /// Takes over the times of an earlier measurement that count as equal to these, so that what
    /// differs has changed.
    pub fn keep(&mut self, earlier: &Measured) {
        for (c, curve) in self.curves.iter_mut().enumerate() {
            let same = |other: &&Curve| other.method == curve.method;
            let Some(of_method) = earlier.curves.iter().find(same) else {
                continue;
            };
            for point in &mut curve.points {
                let same = |other: &&crate::experiment::Point| other.parameter == point.parameter;
                let Some(before) = of_method.points.iter().find(same) else {
                    continue;
                };
                match (&mut point.times.over_first, before.times.over_first) {
                    (Some(now), Some(before)) if are_equal(now, &before) => *now = before,
                    _ => {}
                }
                let has_no_quotient = c == 0 || point.times.over_first.is_none();
                if has_no_quotient && are_equal(&point.times.seconds, &before.times.seconds) {
                    point.times.seconds = before.times.seconds;
                }
            }
        }
        self.derive_seconds();
    }

    /// Writes CSV and plots into a folder that exists, and returns their paths.
    pub fn write(
        &self,
        folder: &Path,
        stage: &str,
        opposite: Option<&Self>,
    ) -> Result<Vec<PathBuf>, Error> {
        let mut files = vec![(CSV, self.csv())];
        for plot in plot::plots(self, opposite) {
            files.push((plot.ending, plot.svg));
        }
        let mut paths = Vec::new();
        for (ending, text) in files {
            let path = file(&self.experiment, folder, stage, ending);
            atomic_file::write(&path, text.as_bytes())?;
            paths.push(path);
        }
        Ok(paths)
    }
}

/// The experiment with the opposite mistake, if it is among these.
pub fn opposite_of<'m, 'a>(
    measured: &Measured,
    all: &'m [Measured<'a>],
) -> Option<&'m Measured<'a>> {
    let name = measured.experiment.opposite?;
    all.iter().find(|other| other.experiment.name == name)
}

/// The times of a point, one for each round, of this number of runs each.
#[derive(Clone, Default)]
struct PointTimes {
    runs: u32,
    seconds: Vec<f64>,
}

/// Whether the first method has a point at the same value of the parameter.
fn shares_parameter(experiment: &Experiment, curves: &[Curve], c: usize, p: usize) -> bool {
    let first = curves[0].points.get(p);
    let is_comparable = c > 0 && experiment.curves_are == Curves::Methods;
    is_comparable && first.is_some_and(|first| first.parameter == curves[c].points[p].parameter)
}

/// Whether two measurements of a time count as equal: their intervals overlap, or are so near to
/// each other that other work on the machine explains it.
fn are_equal(a: &Median, b: &Median) -> bool {
    a.low <= EQUAL_TIMES * b.high && b.low <= EQUAL_TIMES * a.high
}

/// An error if the report of an experiment cannot be written; for a check before
/// the measurement.
pub fn check_writable(experiment: &Experiment, folder: &Path, stage: &str) -> Result<(), Error> {
    atomic_file::check_writable(&file(experiment, folder, stage, CSV))
}

/// The ending of the name of a table.
const CSV: &str = ".csv";

fn file(experiment: &Experiment, folder: &Path, stage: &str, ending: &str) -> PathBuf {
    folder.join(format!("{stage}-{}{ending}", experiment.name))
}

#[cfg(test)]
mod tests;
