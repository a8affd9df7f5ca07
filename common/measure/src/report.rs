//! The report of a stage's experiments: table, CSV and plots.

use std::fmt::Write;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::time::Instant;

use common::{Error, atomic_file};

use crate::experiment::{Axis, Curve, Experiment, HALF_GREY_LEVEL, pareto_front};
use crate::{Effort, plot};

/// An experiment with its times: the shortest of several rounds, in seconds, by
/// curve and point.
pub struct Measured<'e, 'a> {
    /// The experiment.
    pub experiment: &'e Experiment<'a>,
    /// The methods with their errors.
    pub curves: Vec<Curve<'a>>,
    /// The shortest time, by curve and point.
    pub seconds: Vec<Vec<f64>>,
}

impl<'e, 'a> Measured<'e, 'a> {
    /// Measures errors, then times. All methods take turns in every round, so that
    /// other load on the machine affects them equally. The shortest time is the one
    /// with the least disturbance.
    ///
    /// Calls `progress` with the number of measured times and their total, before
    /// the first measurement and after each.
    pub fn new(
        experiment: &'e Experiment<'a>,
        effort: Effort,
        mut progress: impl FnMut(usize, usize),
    ) -> Self {
        let mut curves = (experiment.curves)(effort);
        let rounds = effort.choose(3, 15);
        let points = |curves: &[Curve]| curves.iter().map(|c| c.points.len()).sum::<usize>();
        let (mut done, all) = (0, rounds * points(&curves));
        progress(done, all);
        let unknown = |curve: &Curve| vec![f64::INFINITY; curve.points.len()];
        let mut seconds: Vec<Vec<f64>> = curves.iter().map(unknown).collect();
        for _ in 0..rounds {
            for (curve, seconds) in curves.iter_mut().zip(&mut seconds) {
                for (point, least) in curve.points.iter_mut().zip(seconds) {
                    let start = Instant::now();
                    black_box((point.run)());
                    *least = least.min(start.elapsed().as_secs_f64());
                    done += 1;
                    progress(done, all);
                }
            }
        }
        Self {
            experiment,
            curves,
            seconds,
        }
    }

    /// The table for the terminal.
    #[must_use]
    pub fn table(&self) -> String {
        let Experiment {
            name,
            about,
            knob,
            work,
            error,
            against,
            ..
        } = self.experiment;
        let front = pareto_front(&self.curves);
        let mut text = format!("{name}: {about}\n  error: {error}\n");
        let _ = writeln!(
            text,
            "  {:24} {knob:>12.12} {work:>14.14} {:>9} {:>9} {:>10} {:>7}",
            "method", "rms error", "max", "time", "ratio"
        );
        for (c, curve) in self.curves.iter().enumerate() {
            for (p, point) in curve.points.iter().enumerate() {
                let seconds = self.seconds[c][p];
                // Only where the baseline has the same value of the parameter.
                let baseline = self.curves[0].points.get(p);
                let ratio = baseline
                    .filter(|baseline| baseline.knob == point.knob)
                    .map_or(String::new(), |_| {
                        format!("{:.2}", seconds / self.seconds[0][p])
                    });
                let best = if *against == Axis::Work && front[c][p] {
                    "*"
                } else {
                    " "
                };
                let _ = writeln!(
                    text,
                    "{best} {:24} {:>12} {:>14} {:>9.1e} {:>9.1e} {:>10} {ratio:>7}",
                    curve.method,
                    compact(point.knob),
                    compact(point.work),
                    point.rms,
                    point.max,
                    duration(seconds),
                );
            }
        }
        for curve in &self.curves {
            let summary = self.summary(curve);
            if !summary.is_empty() {
                let _ = writeln!(text, "  {}: {summary}", curve.method);
            }
        }
        text
    }

    /// Slope, work to reach half a grey level, and remark.
    fn summary(&self, curve: &Curve) -> String {
        let axis = self.experiment.against;
        let everywhere = (0.0, f64::INFINITY);
        let between = curve.slope.map_or(everywhere, |slope| slope.between);
        let mut parts = Vec::new();
        if let Some(fitted) = curve.fitted_slope(axis, between) {
            let theory = curve.slope.map_or(String::new(), |slope| {
                format!(" (theory {})", slope.expected)
            });
            parts.push(format!("slope {fitted:.2}{theory}"));
        }
        if axis == Axis::Work
            && let Some((work, beyond)) = curve.work_to_reach(HALF_GREY_LEVEL)
        {
            let beyond = if beyond { ", extrapolated" } else { "" };
            parts.push(format!("1/510 takes {work:.0}{beyond}"));
        }
        if !curve.remark.is_empty() {
            parts.push(curve.remark.to_owned());
        }
        parts.join("; ")
    }

    /// All measurements as comma-separated values.
    #[must_use]
    pub fn csv(&self) -> String {
        let Experiment {
            name, knob, work, ..
        } = self.experiment;
        let front = pareto_front(&self.curves);
        let mut text =
            format!("experiment,method,{knob},{work},rms error,max error,seconds,pareto\n");
        for (c, curve) in self.curves.iter().enumerate() {
            for (p, point) in curve.points.iter().enumerate() {
                let _ = writeln!(
                    text,
                    "{name},{},{},{},{:e},{:e},{:e},{}",
                    curve.method,
                    point.knob,
                    point.work,
                    point.rms,
                    point.max,
                    self.seconds[c][p],
                    front[c][p],
                );
            }
        }
        text
    }

    /// Writes CSV and plots into a folder that exists, and returns their paths.
    pub fn write(&self, folder: &Path, stage: &str) -> Result<Vec<PathBuf>, Error> {
        let mut files = vec![(TABLE.to_owned(), self.csv())];
        files.extend(plot::plots(self)?);
        let mut paths = Vec::new();
        for (ending, text) in files {
            let path = file(self.experiment, folder, stage, &ending);
            atomic_file::write(&path, text.as_bytes())?;
            paths.push(path);
        }
        Ok(paths)
    }
}

/// An error if the report of an experiment cannot be written; for a check before
/// the measurement.
pub fn check_writable(experiment: &Experiment, folder: &Path, stage: &str) -> Result<(), Error> {
    atomic_file::check_writable(&file(experiment, folder, stage, TABLE))
}

/// The suffix of the file of a table.
const TABLE: &str = ".csv";

fn file(experiment: &Experiment, folder: &Path, stage: &str, ending: &str) -> PathBuf {
    folder.join(format!("{stage}-{}{ending}", experiment.name))
}

/// A number in few characters.
fn compact(number: f64) -> String {
    if number == 0.0 || (1e-3..1e10).contains(&number.abs()) {
        format!("{}", libm::round(number * 1e4) / 1e4)
    } else {
        format!("{number:.2e}")
    }
}

/// A time, in the unit in which it has few digits.
fn duration(seconds: f64) -> String {
    match seconds {
        ..1e-6 => format!("{:.0} ns", seconds * 1e9),
        ..1e-3 => format!("{:.1} us", seconds * 1e6),
        ..1.0 => format!("{:.1} ms", seconds * 1e3),
        _ => format!("{seconds:.2} s"),
    }
}

#[cfg(test)]
mod tests;
