//! The report of an experiment: table, CSV and plots.

mod csv;
mod table;

use std::path::{Path, PathBuf};

use common::{Error, Median, atomic_file};

use crate::experiment::{Curve, Curves, Experiment, Point, Times};
use crate::plot;
use crate::provenance;
use crate::rounds::{Rounds, Turn};

pub use csv::{Named, csv};

/// An experiment with its errors and times.
pub struct Measured<'a> {
    /// The experiment.
    pub experiment: Experiment<'a>,
    /// The methods with their errors and times.
    pub curves: Vec<Curve<'a>>,
}

/// The least processor time of a measurement in seconds, for which short runs are repeated.
const MIN_TIME: f64 = 1e-3;

impl<'a> Measured<'a> {
    /// Measures errors, then times in a number of [`Rounds`].
    ///
    /// Calls `progress` with the number of measured times and their total, before
    /// the first measurement and after each.
    pub fn new(
        experiment: Experiment<'a>,
        rounds: usize,
        mut progress: impl FnMut(usize, usize),
    ) -> Self {
        let curves = (experiment.curves)();
        let mut rounds = Rounds::new(&curves, rounds, MIN_TIME);
        let mut measured = Self { experiment, curves };
        let [mut last, all] = rounds.progress();
        progress(last, all);
        while let Some(turn) = rounds.turn() {
            rounds.took(measured.times(turn).measure(turn.runs));
            let [done, _] = rounds.progress();
            if done > last {
                last = done;
                progress(done, all);
            }
        }
        measured.set_times(&rounds);
        measured
    }

    /// The run whose turn it is.
    fn times(&mut self, turn: Turn) -> &mut Times<'a> {
        &mut self.curves[turn.curve].points[turn.point].times
    }

    /// Runs the point whose turn it is, for a clock elsewhere.
    pub fn run(&mut self, turn: Turn) {
        self.times(turn).run(turn.runs);
    }

    /// Takes the medians of the times that are measured. Those of all methods but the first follow from the times of
    /// the first and the quotients of the rounds, so that times and quotients say the same.
    pub fn set_times(&mut self, rounds: &Rounds) {
        for c in 0..self.curves.len() {
            for p in 0..self.curves[c].points.len() {
                let quotient = self
                    .shares_parameter(c, p)
                    .then(|| rounds.quotient(c, 0, p));
                let seconds = match quotient {
                    Some(Median { low, value, high }) => {
                        let unit = self.curves[0].points[p].times.seconds.value;
                        Median {
                            low: low * unit,
                            value: value * unit,
                            high: high * unit,
                        }
                    }
                    None => Median::of(rounds.of(c, p).to_vec()),
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
    pub fn points(&self) -> impl Iterator<Item = (usize, &Point<'a>)> {
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

/// The ending of the name of a table.
const CSV: &str = ".csv";

fn file(experiment: &Experiment, folder: &Path, stage: &str, ending: &str) -> PathBuf {
    folder.join(format!("{stage}-{}{ending}", experiment.name))
}

#[cfg(test)]
mod tests;
