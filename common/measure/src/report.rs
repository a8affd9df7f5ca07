//! The report of an experiment: table, CSV and plots.

mod csv;
mod table;

use std::path::{Path, PathBuf};

use common::{Error, Median, atomic_file};

use crate::experiment::{Curve, Curves, Experiment, Point};
use crate::plot;
use crate::provenance;

pub use csv::{Named, csv};

/// An experiment with its errors and times.
pub struct Measured<'a> {
    /// The experiment.
    pub experiment: Experiment<'a>,
    /// The methods with their errors and times.
    pub curves: Vec<Curve<'a>>,
}

/// The least processor time of a measurement in seconds, for which short runs are repeated.
const LEAST_TIME: f64 = 1e-3;

/// The fewest rounds, and the processor time in seconds that is enough for all rounds of an experiment.
const FEWEST_ROUNDS: usize = 9;
const ENOUGH_TIME: f64 = 6.0;

/// The most runs of a measurement.
const MOST_RUNS: f64 = 1e4;

impl<'a> Measured<'a> {
    /// Measures errors, then times in a number of rounds, or in fewer if these take long. In each round
    /// all methods take turns at each value of the parameter, so that other load on the machine affects
    /// them equally.
    ///
    /// Calls `progress` with the number of measured times and their total, before
    /// the first measurement and after each.
    pub fn new(
        experiment: Experiment<'a>,
        rounds: usize,
        mut progress: impl FnMut(usize, usize),
    ) -> Self {
        let mut curves = (experiment.curves)();
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
        let mut total = 0.0;
        for round in 0..rounds {
            if round >= FEWEST_ROUNDS && total > ENOUGH_TIME {
                break;
            }
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
        let mut measured = Self { experiment, curves };
        measured.set_times(&times);
        measured
    }

    /// Takes the medians of measured times. Those of all methods but the first follow from the times of
    /// the first and the quotients of the rounds, so that times and quotients say the same.
    fn set_times(&mut self, times: &[Vec<PointTimes>]) {
        for (c, of_curve) in times.iter().enumerate() {
            for (p, own) in of_curve.iter().enumerate() {
                let quotient = self
                    .shares_parameter(c, p)
                    .then(|| Median::of_quotients(&own.seconds, &times[0][p].seconds));
                let seconds = match quotient {
                    Some(Median { low, value, high }) => {
                        let unit = self.curves[0].points[p].times.seconds.value;
                        Median {
                            low: low * unit,
                            value: value * unit,
                            high: high * unit,
                        }
                    }
                    None => Median::of(own.seconds.clone()),
                };
                let times = &mut self.curves[c].points[p].times;
                (times.seconds, times.over_first) = (seconds, quotient);
            }
        }
    }

    /// Whether the first method has a point at the same value of the parameter, to be compared with.
    fn shares_parameter(&self, c: usize, p: usize) -> bool {
        let first = self.curves[0].points.get(p);
        let is_comparable = c > 0 && self.experiment.curves_are == Curves::Methods;
        let parameter = self.curves[c].points[p].parameter;
        is_comparable && first.is_some_and(|first| first.parameter == parameter)
    }

    /// All points, each with the number of its curve.
    pub(crate) fn points(&self) -> impl Iterator<Item = (usize, &Point<'a>)> {
        let curves = self.curves.iter().enumerate();
        curves.flat_map(|(c, curve)| curve.points.iter().map(move |point| (c, point)))
    }

    /// The curve of a method.
    pub(crate) fn curve(&self, method: &str) -> Option<&Curve<'a>> {
        self.curves.iter().find(|curve| curve.method == method)
    }

    /// All values of the parameter, from small to large.
    pub(crate) fn parameters(&self) -> Vec<f64> {
        let mut all: Vec<_> = self.points().map(|(_, point)| point.parameter).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        all
    }

    /// Writes CSV and plots into a folder that exists, and returns their paths.
    pub fn write(
        &self,
        folder: &Path,
        stage: &str,
        opposite: Option<&Self>,
    ) -> Result<Vec<PathBuf>, Error> {
        let all = [Named {
            name: self.experiment.name.to_owned(),
            measured: self,
        }];
        let path = file(&self.experiment, folder, stage, CSV);
        atomic_file::write(&path, csv(&provenance::here(), &all).as_bytes())?;
        let mut paths = vec![path];
        paths.extend(self.write_plots(folder, stage, opposite)?);
        Ok(paths)
    }

    /// Writes the plots into a folder that exists, and returns their paths.
    pub fn write_plots(
        &self,
        folder: &Path,
        stage: &str,
        opposite: Option<&Self>,
    ) -> Result<Vec<PathBuf>, Error> {
        let mut paths = Vec::new();
        for plot in plot::plots(self, opposite) {
            let path = file(&self.experiment, folder, stage, plot.ending);
            atomic_file::write(&path, plot.svg.as_bytes())?;
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

/// The ending of the name of a table.
const CSV: &str = ".csv";

fn file(experiment: &Experiment, folder: &Path, stage: &str, ending: &str) -> PathBuf {
    folder.join(format!("{stage}-{}{ending}", experiment.name))
}

#[cfg(test)]
mod tests;
