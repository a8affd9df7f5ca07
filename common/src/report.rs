//! The report of a stage's experiments: table, CSV and plots.

use std::fmt::Write;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::time::Instant;

use crate::experiment::{Axis, Curve, Experiment, HALF_GREY_LEVEL, pareto_front};
use crate::progress::terminal_bar;
use crate::{Effort, Error, plot, whole_file};

/// An experiment with its times: the least of several rounds, in seconds, by
/// curve and point.
pub(crate) struct Measured<'e, 'a> {
    pub experiment: &'e Experiment<'a>,
    pub curves: Vec<Curve<'a>>,
    pub seconds: Vec<Vec<f64>>,
}

impl<'e, 'a> Measured<'e, 'a> {
    /// Measures errors, then times. All methods take turns in every round, so
    /// that what else the machine does hits them alike; the least time is that
    /// which was disturbed least.
    pub fn new(experiment: &'e Experiment<'a>, effort: Effort) -> Self {
        let mut curves = (experiment.curves)(effort);
        let rounds = effort.choose(3, 15);
        let points = |curves: &[Curve]| curves.iter().map(|c| c.points.len()).sum::<usize>();
        let bar = terminal_bar(experiment.name, (rounds * points(&curves)) as u64);
        let unknown = |curve: &Curve| vec![f64::INFINITY; curve.points.len()];
        let mut seconds: Vec<Vec<f64>> = curves.iter().map(unknown).collect();
        for _ in 0..rounds {
            for (curve, seconds) in curves.iter_mut().zip(&mut seconds) {
                for (point, least) in curve.points.iter_mut().zip(seconds) {
                    let start = Instant::now();
                    black_box((point.run)());
                    *least = least.min(start.elapsed().as_secs_f64());
                    bar.inc(1);
                }
            }
        }
        bar.finish_and_clear();
        Self {
            experiment,
            curves,
            seconds,
        }
    }

    /// The table for the terminal.
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
                // Only where the baseline has the same turn of the knob.
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

    /// Slope, work to half a grey level, remark.
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

    /// Everything as comma-separated values.
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

    /// Writes CSV and plots into a folder that exists, and says which files.
    pub fn write(&self, folder: &Path, stage: &str) -> Result<Vec<PathBuf>, Error> {
        let mut files = vec![(TABLE.to_owned(), self.csv())];
        files.extend(plot::plots(self)?);
        let mut paths = Vec::new();
        for (ending, text) in files {
            let path = file(self.experiment, folder, stage, &ending);
            whole_file::write(&path, text.as_bytes())?;
            paths.push(path);
        }
        Ok(paths)
    }
}

/// Says what would keep the report of an experiment from being written, before
/// anything is measured.
pub(crate) fn check_writable(
    experiment: &Experiment,
    folder: &Path,
    stage: &str,
) -> Result<(), Error> {
    whole_file::check_writable(&file(experiment, folder, stage, TABLE))
}

/// What the file of a table ends in.
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

/// A time in the unit that leaves few digits.
fn duration(seconds: f64) -> String {
    match seconds {
        ..1e-6 => format!("{:.0} ns", seconds * 1e9),
        ..1e-3 => format!("{:.1} us", seconds * 1e6),
        ..1.0 => format!("{:.1} ms", seconds * 1e3),
        _ => format!("{seconds:.2} s"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::{Point, Slope};

    fn experiment() -> Experiment<'static> {
        Experiment {
            name: "square-root",
            about: "is the error one over the square root?",
            knob: "n",
            work: "steps",
            error: "of nothing",
            against: Axis::Work,
            curves: Box::new(|_| {
                let point = |n: f64| Point::new(n, n, [1.0 / n.sqrt()], move || n);
                vec![Curve {
                    method: "plain",
                    remark: "remarkable",
                    slope: Some(Slope {
                        expected: -0.5,
                        tolerance: 0.01,
                        between: (1.0, 1e9),
                    }),
                    points: [1.0, 16.0, 256.0].map(point).into(),
                }]
            }),
        }
    }

    #[test]
    fn the_table_tells_slope_price_and_remark() {
        let experiment = experiment();
        let table = Measured::new(&experiment, Effort::Quick).table();
        assert!(table.contains("slope -0.50 (theory -0.5)"), "{table}");
        // (1/510)^-2
        assert!(
            table.contains("1/510 takes 260100, extrapolated"),
            "{table}"
        );
        assert!(table.contains("remarkable"), "{table}");
        assert_eq!(table.matches("* plain").count(), 3, "{table}");
    }

    /// Two curves whose first points have the same knob, and times made up.
    fn measured<'e>(experiment: &'e Experiment<'static>) -> Measured<'e, 'static> {
        let curve = |method, points: &[[f64; 3]]| Curve {
            method,
            remark: "",
            slope: None,
            points: points
                .iter()
                .map(|[knob, work, error]| Point::new(*knob, *work, [*error], || 0.0))
                .collect(),
        };
        let curves = vec![
            curve("plain", &[[1.0, 10.0, 0.5], [2.0, 20.0, 0.25]]),
            curve("clever", &[[1.0, 10.0, 0.1], [3.0, 30.0, 0.5]]),
        ];
        Measured {
            experiment,
            curves,
            seconds: vec![vec![0.002, 0.004], vec![0.001, 3.0]],
        }
    }

    /// Nothing beats the clever method's first point. The plain one's error has
    /// the slope -1; it takes 10 * 0.5 * 510 steps to half a grey level.
    #[test]
    fn a_row_has_its_time_beside_that_of_the_same_knob() {
        let mut experiment = experiment();
        let rows = |star| {
            [
                "square-root: is the error one over the square root?".to_owned(),
                "  error: of nothing".to_owned(),
                "  method                              n          steps rms error       max       time   ratio".to_owned(),
                "  plain                               1             10    5.0e-1    5.0e-1     2.0 ms    1.00".to_owned(),
                "  plain                               2             20    2.5e-1    2.5e-1     4.0 ms    1.00".to_owned(),
                format!("{star} clever                              1             10    1.0e-1    1.0e-1     1.0 ms    0.50"),
                "  clever                              3             30    5.0e-1    5.0e-1     3.00 s        ".to_owned(),
            ]
        };
        let summary = "  plain: slope -1.00; 1/510 takes 2550, extrapolated";
        let rising = "  clever: slope 1.46";
        let lines = |measured: Measured| {
            let table = measured.table();
            table.lines().map(str::to_owned).collect::<Vec<_>>()
        };
        let expected = [&rows("*")[..], &[summary.to_owned(), rising.to_owned()]].concat();
        assert_eq!(lines(measured(&experiment)), expected);

        // Against the knob there is no price, and none that is the best for it.
        experiment.against = Axis::Knob;
        let summary = "  plain: slope -1.00".to_owned();
        let expected = [&rows(" ")[..], &[summary, rising.to_owned()]].concat();
        assert_eq!(lines(measured(&experiment)), expected);
    }

    #[test]
    fn a_curve_of_which_nothing_can_be_said_has_no_summary() {
        let experiment = experiment();
        let mut measured = measured(&experiment);
        measured.curves[0].points.truncate(1);
        let summary = measured.summary(&measured.curves[0]);
        assert_eq!(summary, "");
        assert!(!measured.table().contains("plain: "));
    }

    #[test]
    fn csv_has_all_digits() {
        let lines = [
            "experiment,method,n,steps,rms error,max error,seconds,pareto",
            "square-root,plain,1,10,5e-1,5e-1,2e-3,false",
            "square-root,plain,2,20,2.5e-1,2.5e-1,4e-3,false",
            "square-root,clever,1,10,1e-1,1e-1,1e-3,true",
            "square-root,clever,3,30,5e-1,5e-1,3e0,false",
        ];
        let experiment = experiment();
        let csv = measured(&experiment).csv();
        assert!(csv.lines().eq(lines), "{csv}");
    }

    #[test]
    fn csv_and_plots_are_written() {
        let experiment = experiment();
        let folder = tempfile::tempdir().unwrap();
        check_writable(&experiment, folder.path(), "a00").unwrap();
        let paths = measured(&experiment).write(folder.path(), "a00").unwrap();
        assert!(paths[0].ends_with("a00-square-root.csv"));
        let csv = std::fs::read_to_string(&paths[0]).unwrap();
        assert_eq!(csv.lines().count(), 5);
        assert!(paths.len() > 1);
        for svg in &paths[1..] {
            assert!(std::fs::read_to_string(svg).unwrap().contains("<svg"));
        }
        let missing = folder.path().join("missing");
        assert!(check_writable(&experiment, &missing, "a00").is_err());
    }

    #[test]
    fn times_are_printed_in_a_fitting_unit() {
        assert_eq!(duration(12e-9), "12 ns");
        assert_eq!(duration(3.44e-5), "34.4 us");
        assert_eq!(duration(0.25), "250.0 ms");
        assert_eq!(duration(2.0), "2.00 s");
    }

    #[test]
    fn numbers_take_few_characters() {
        let shown = [0.0, 1.0, 0.123_46, 1e-3, 9.9e-4, 9e9, 1e10, -2.5].map(compact);
        let expected = [
            "0",
            "1",
            "0.1235",
            "0.001",
            "9.90e-4",
            "9000000000",
            "1.00e10",
            "-2.5",
        ];
        assert_eq!(shown, expected);
    }
}
