//! The report of an experiment: table, CSV and plots.

mod csv;
mod table;

use std::path::{Path, PathBuf};

use common::{Error, Median, atomic_file};

use crate::experiment::{Curve, Curves, Experiment};
use crate::{Effort, plot};

pub(crate) use table::{compact, duration};

/// An experiment with its errors and times.
pub struct Measured<'e, 'a> {
    /// The experiment.
    pub experiment: &'e Experiment<'a>,
    /// The methods with their errors and times.
    pub curves: Vec<Curve<'a>>,
}

impl<'e, 'a> Measured<'e, 'a> {
    /// Measures errors, then times. All methods take turns in every round, so that
    /// other load on the machine affects them equally.
    ///
    /// Calls `progress` with the number of measured times and their total, before
    /// the first measurement and after each.
    pub fn new(
        experiment: &'e Experiment<'a>,
        effort: Effort,
        mut progress: impl FnMut(usize, usize),
    ) -> Self {
        let mut curves = (experiment.curves)(effort);
        let rounds = effort.choose(9, 15);
        let points: usize = curves.iter().map(|curve| curve.points.len()).sum();
        let (mut done, all) = (0, rounds * points);
        progress(done, all);
        for _ in 0..rounds {
            for curve in &mut curves {
                for point in &mut curve.points {
                    point.times.measure();
                    done += 1;
                    progress(done, all);
                }
            }
        }
        Self { experiment, curves }
    }

    /// The time of a point over the first method's time, if both have the same value of
    /// the parameter. The first method itself has none.
    fn time_over_first(&self, curve: usize, point: usize) -> Option<Median> {
        if curve == 0 || self.experiment.curves_are == Curves::Problems {
            return None;
        }
        let own = &self.curves[curve].points[point];
        let first = self.curves[0].points.get(point)?;
        if own.parameter != first.parameter {
            return None;
        }
        let quotients = Median::of_quotients(&own.times.seconds, &first.times.seconds);
        Some(quotients)
    }

    /// Writes CSV and plots into a folder that exists, and returns their paths.
    pub fn write(&self, folder: &Path, stage: &str) -> Result<Vec<PathBuf>, Error> {
        let mut files = vec![(CSV, self.csv())];
        for plot in plot::plots(self) {
            files.push((plot.ending, plot.svg));
        }
        let mut paths = Vec::new();
        for (ending, text) in files {
            let path = file(self.experiment, folder, stage, ending);
            atomic_file::write(&path, text.as_bytes())?;
            paths.push(path);
        }
        Ok(paths)
    }
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
