//! The report of a stage's experiments: table, CSV and plots.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use common::{Error, Median, atomic_file, text};

use crate::experiment::{Axis, Curve, Experiment, HALF_GREY_LEVEL, pareto_front};

use crate::{Effort, plot, provenance};

/// An experiment with its times.
pub struct Measured<'e, 'a> {
    /// The experiment.
    pub experiment: &'e Experiment<'a>,
    /// The methods with their errors.
    pub curves: Vec<Curve<'a>>,
    /// The times in seconds, by curve, point and round.
    pub seconds: Vec<Vec<Vec<f64>>>,
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
        let none = |curve: &Curve| vec![Vec::new(); curve.points.len()];
        let mut seconds: Vec<Vec<Vec<f64>>> = curves.iter().map(none).collect();
        let rounds = effort.choose(9, 15);
        let (mut done, all) = (0, rounds * seconds.iter().map(Vec::len).sum::<usize>());
        progress(done, all);
        for _ in 0..rounds {
            for (curve, seconds) in curves.iter_mut().zip(&mut seconds) {
                for (point, seconds) in curve.points.iter_mut().zip(seconds) {
                    let start = Instant::now();
                    (point.run)();
                    seconds.push(start.elapsed().as_secs_f64());
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

    /// The median time of a point, in seconds.
    pub(crate) fn time(&self, curve: usize, point: usize) -> Median {
        Median::of(self.seconds[curve][point].clone())
    }

    /// The time of a point over the first method's time, if both have the same value of
    /// the parameter.
    fn ratio(&self, curve: usize, point: usize) -> Option<Median> {
        let first = self.curves[0].points.get(point)?;
        let (own, first_seconds) = (&self.seconds[curve][point], &self.seconds[0].get(point)?);
        let is_same_parameter = first.parameter == self.curves[curve].points[point].parameter;
        let is_comparable = curve > 0 && is_same_parameter && !self.experiment.of_problems;
        is_comparable.then(|| Median::of_quotients(own, first_seconds))
    }

    /// The table for the terminal.
    pub fn table(&self) -> String {
        let e = self.experiment;
        let front = pareto_front(&self.curves);
        let has_best = e.against == Axis::Work && !e.of_problems;
        let (name, about, unit, exact) = (e.name, e.about, e.unit, e.exact);
        let in_ulps = self
            .curves
            .iter()
            .flat_map(|curve| &curve.points)
            .any(|p| p.problem.is_some());
        let ulps = if in_ulps { "; 99 % and max in ulp" } else { "" };
        let mut text = format!("{name}: {about}\n  {} ({unit}), {exact}{ulps}\n", e.error);
        let width = |name: &str, least: usize| name.chars().count().max(least);
        let (k, w) = (width(e.parameter, 12), width(e.work, 14));
        let _ = writeln!(
            text,
            "  {:24} {:>k$} {:>w$}     error      99 %       max condition       time  time / first method",
            "method", e.parameter, e.work
        );
        for (c, curve) in self.curves.iter().enumerate() {
            for (p, point) in curve.points.iter().enumerate() {
                let ratio = self.ratio(c, p).map(|ratio| format!("  {ratio}"));
                let condition = point.problem.map(|one| format!("{:.1e}", one.condition));
                let _ = writeln!(
                    text,
                    "{} {:24} {:>k$} {:>w$} {:>9.1e} {:>9.1e} {:>9.1e} {:>9} {:>10}{}",
                    if has_best && front[c][p] { "*" } else { " " },
                    curve.method,
                    compact(point.parameter),
                    compact(point.work),
                    point.rms,
                    point.p99,
                    point.max,
                    condition.unwrap_or_default(),
                    duration(self.time(c, p).value),
                    ratio.unwrap_or_default(),
                );
            }
        }
        for (c, curve) in self.curves.iter().enumerate() {
            let summary = self.summary(c, curve);
            if !summary.is_empty() {
                let _ = writeln!(text, "  {}: {summary}", curve.method);
            }
        }
        if !e.of_problems {
            let _ = writeln!(text, "  unbeaten in error and time: {}", self.unbeaten());
        }
        text
    }

    /// Slope, work to reach half a grey level, and time and error beside the first method's.
    fn summary(&self, c: usize, curve: &Curve) -> String {
        let mut parts = Vec::new();
        if let Some(fit) = self.experiment.fit(curve) {
            let theory = |(slope, _)| format!(" (theory {slope})");
            let theory = curve.slope.map_or(String::new(), theory);
            parts.push(format!("{fit}{theory}"));
        }
        let has_mark = self.experiment.can_be_seen(&self.curves);
        let mark = has_mark.then(|| curve.work_to_reach(HALF_GREY_LEVEL));
        if let Some((work, beyond)) = mark.flatten() {
            let beyond = if beyond { ", extrapolated" } else { "" };
            let unit = self.experiment.work;
            let work = compact(libm::round(work));
            parts.push(format!("1/510 takes {work} {unit}{beyond}"));
        }
        parts.extend(curve.blame());
        parts.extend(self.beside_first(c));
        parts.join("; ")
    }

    /// The time and the error of a method at the last value of the parameter that it shares
    /// with the first, over those of the first.
    fn beside_first(&self, c: usize) -> Option<String> {
        let points = &self.curves[c].points;
        let last = |p| Some((p, self.ratio(c, p)?));
        let (p, time) = (0..points.len()).rev().find_map(last)?;
        let (first, own) = (self.curves[0].points[p].rms, points[p].rms);
        let error = match own / first {
            _ if own == 0.0 => "no error".to_owned(),
            ratio @ 0.01..1e4 => format!("{ratio:.2} times its error"),
            ratio if ratio.is_finite() => format!("{ratio:.1e} times its error"),
            _ => format!("an error of {own:.1e}, where it has none"),
        };
        let (method, parameter) = (self.curves[0].method, compact(points[p].parameter));
        Some(format!(
            "beside {method} at {parameter}: {error}, time {time}"
        ))
    }

    /// All measurements as comma-separated values, below lines with `#` about their
    /// origin.
    pub fn csv(&self) -> String {
        let e = self.experiment;
        let name = text::name(e.name);
        let (about, unit, exact) = (e.about, e.unit, e.exact);
        let seeds: Vec<_> = e.seeds.iter().map(u64::to_string).collect();
        let seeds = match &seeds[..] {
            [] => "no random numbers".to_owned(),
            seeds => seeds.join(" "),
        };
        let rounds = self.seconds.iter().flatten().map(Vec::len).max();
        let rounds = rounds.unwrap_or(0);
        let mut text = format!(
            "# experiment: {name}: {about}\n# error: {} ({unit}), {exact}\n\
             # work: counted: {}\n# seconds: median of {rounds} rounds by turns\n\
             # low and high: interval of 95 % for the median\n# seed: {seeds}\n",
            e.error, e.work
        );
        for (name, value) in provenance::lines() {
            let _ = writeln!(text, "# {name}: {value}");
        }
        let [parameter, work, error] = [e.parameter, e.work, e.error].map(quoted);
        let _ = writeln!(
            text,
            "experiment,method,{parameter},{work},{error},99 %,max,condition,problem's error,\
             seconds,low,high,pareto"
        );
        let name = quoted(&name);
        let front = pareto_front(&self.curves);
        for (c, curve) in self.curves.iter().enumerate() {
            for (p, point) in curve.points.iter().enumerate() {
                let Median { low, value, high } = self.time(c, p);
                let problem = point
                    .problem
                    .map(|one| format!("{:e},{:e}", one.condition, one.error));
                let problem = problem.as_deref().unwrap_or(",");
                let _ = writeln!(
                    text,
                    "{name},{},{},{},{:e},{:e},{:e},{problem},{value:e},{low:e},{high:e},{}",
                    quoted(curve.method),
                    text::number(point.parameter),
                    text::number(point.work),
                    point.rms,
                    point.p99,
                    point.max,
                    front[c][p],
                );
            }
        }
        text
    }

    /// Writes CSV and plots into a folder that exists, and returns their paths.
    pub fn write(&self, folder: &Path, stage: &str) -> Result<Vec<PathBuf>, Error> {
        let table = std::iter::once((TABLE, self.csv()));
        let write = |(ending, text): (_, String)| {
            let path = file(self.experiment, folder, stage, ending);
            atomic_file::write(&path, text.as_bytes())?;
            Ok(path)
        };
        table.chain(plot::plots(self)).map(write).collect()
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

/// A field of a CSV file (RFC 4180).
fn quoted(field: &str) -> String {
    if field.contains([',', '"']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}

/// A number in few characters.
pub(crate) fn compact(number: f64) -> String {
    if number == 0.0 || (1e-3..1e10).contains(&number.abs()) {
        format!("{}", libm::round(number * 1e4) / 1e4)
    } else {
        format!("{number:.2e}")
    }
}

/// A time, in the unit in which it has few digits.
pub(crate) fn duration(seconds: f64) -> String {
    format!(
        "{:.1?}",
        Duration::try_from_secs_f64(seconds).unwrap_or_default()
    )
}

#[cfg(test)]
mod tests;
