//! Error against work: what being less wrong costs.
//!
//! As for solvers of differential equations, several methods do the same with
//! a knob turned from coarse to fine, and each turn is a point of a diagram:
//! how far off, and at what price. The price is counted, which is the same on
//! every machine, and timed, which is not.

use crate::Effort;

/// Half a grey level of an 8-bit picture: smaller errors can't be seen.
pub const HALF_GREY_LEVEL: f64 = 1.0 / 510.0;

/// What the slopes of an experiment are taken against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The counted work: turning the knob costs something.
    Work,
    /// The knob itself: it turns the task, not the method.
    Knob,
}

/// Methods that are compared.
pub struct Experiment<'a> {
    /// The name on the command line, in kebab case.
    pub name: &'a str,
    /// The question, in one line.
    pub about: &'a str,
    /// What the knob turns.
    pub knob: &'a str,
    /// What the work counts.
    pub work: &'a str,
    /// What the error is of, and against which exact value.
    pub error: &'a str,
    /// What slopes are taken against.
    pub against: Axis,
    /// Measures all methods; the first is the baseline of the times.
    pub curves: Box<dyn Fn(Effort) -> Vec<Curve<'a>> + 'a>,
}

/// A method at all turns of the knob.
pub struct Curve<'a> {
    /// Its name.
    pub method: &'a str,
    /// What a reader should know of it: for the most exact one, why it is not
    /// in the renderer. May be empty.
    pub remark: &'a str,
    /// The slope that theory gives, if it does.
    pub slope: Option<Slope>,
    /// From coarse to fine.
    pub points: Vec<Point<'a>>,
}

/// A slope of log error over log work, or over log knob.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// What theory gives.
    pub expected: f64,
    /// How far a measured one may be off.
    pub tolerance: f64,
    /// The values on the axis that count: before, theory may not hold yet, and
    /// after, rounding may have taken over.
    pub between: (f64, f64),
}

/// One measurement.
pub struct Point<'a> {
    /// The turn of the knob.
    pub knob: f64,
    /// The counted work.
    pub work: f64,
    /// The root of the mean squared error.
    pub rms: f64,
    /// The greatest error.
    pub max: f64,
    /// The work itself, to be timed: without finding out the error. What it
    /// returns keeps the compiler from leaving it out.
    pub run: Box<dyn FnMut() -> f64 + 'a>,
}

impl<'a> Point<'a> {
    /// The measurement whose errors are these, at least one.
    pub fn new(
        knob: f64,
        work: f64,
        errors: impl IntoIterator<Item = f64>,
        run: impl FnMut() -> f64 + 'a,
    ) -> Self {
        let (mut count, mut squares, mut max) = (0.0, 0.0, 0.0_f64);
        for error in errors {
            count += 1.0;
            squares += error * error;
            max = max.max(error.abs());
        }
        Self {
            knob,
            work,
            rms: (squares / count).sqrt(),
            max,
            run: Box::new(run),
        }
    }

    /// The place on an axis.
    #[must_use]
    pub const fn on(&self, axis: Axis) -> f64 {
        match axis {
            Axis::Work => self.work,
            Axis::Knob => self.knob,
        }
    }
}

impl Curve<'_> {
    /// The slope of log error over log `axis` among the points between two
    /// values, by least squares; none with fewer than two points with an error.
    #[must_use]
    pub fn fitted_slope(&self, axis: Axis, between: (f64, f64)) -> Option<f64> {
        let logs: Vec<_> = self
            .points
            .iter()
            .map(|point| (point.on(axis), point.rms))
            .filter(|(x, error)| (between.0..=between.1).contains(x) && *error > 0.0)
            .map(|(x, error)| (libm::log10(x), libm::log10(error)))
            .collect();
        let count = logs.len() as f64;
        let mean = |f: fn(&(f64, f64)) -> f64| logs.iter().map(f).sum::<f64>() / count;
        let (x, y) = (mean(|log| log.0), mean(|log| log.1));
        let along: f64 = logs.iter().map(|log| (log.0 - x) * (log.0 - x)).sum();
        let across: f64 = logs.iter().map(|log| (log.0 - x) * (log.1 - y)).sum();
        let slope = across / along;
        slope.is_finite().then_some(slope)
    }

    /// The work that brings the error down to `target`: between two points on
    /// a straight line through both, beyond the last on the fitted one (then
    /// the flag is true); none if the error does not fall.
    #[must_use]
    pub fn work_to_reach(&self, target: f64) -> Option<(f64, bool)> {
        let reached = self.points.iter().position(|point| point.rms <= target);
        match reached {
            Some(0) => Some((self.points[0].work, false)),
            Some(at) => {
                let (a, b) = (&self.points[at - 1], &self.points[at]);
                let slope = libm::log(b.rms / a.rms) / libm::log(b.work / a.work);
                let work = a.work * libm::pow(target / a.rms, 1.0 / slope);
                Some((if work.is_finite() { work } else { b.work }, false))
            }
            None => {
                let last = self.points.last()?;
                let slope = self.fitted_slope(Axis::Work, (last.work / 300.0, last.work))?;
                let work = last.work * libm::pow(target / last.rms, 1.0 / slope);
                (slope < -0.01 && work.is_finite()).then_some((work, true))
            }
        }
    }
}

/// Which points no other beats: none has both less work and a smaller error.
/// By curve and point.
#[must_use]
pub fn pareto_front(curves: &[Curve]) -> Vec<Vec<bool>> {
    let all = || curves.iter().flat_map(|curve| &curve.points);
    let beats = |a: &Point, b: &Point| {
        a.work <= b.work && a.rms <= b.rms && (a.work < b.work || a.rms < b.rms)
    };
    let unbeaten = |point: &Point| !all().any(|other| beats(other, point));
    let front = curves
        .iter()
        .map(|curve| curve.points.iter().map(unbeaten).collect());
    front.collect()
}

/// Checks in a test that a stage has experiments, and that their measured slopes
/// are those of theory.
///
/// # Panics
///
/// If one is not; the message shows all that aren't.
pub fn check_slopes(experiments: &[Experiment], effort: Effort) {
    assert!(!experiments.is_empty(), "there are no experiments");
    let mut wrong = Vec::new();
    for experiment in experiments {
        for curve in (experiment.curves)(effort) {
            let Some(slope) = curve.slope else { continue };
            let fitted = curve.fitted_slope(experiment.against, slope.between);
            if fitted.is_none_or(|fitted| (fitted - slope.expected).abs() > slope.tolerance) {
                let (name, method) = (experiment.name, curve.method);
                wrong.push(format!(
                    "{name}: {method}: {fitted:?}, not {}",
                    slope.expected
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("; "));
}

/// The counted work of every point, for a snapshot: it is the same on every
/// machine. The errors are given to two digits.
#[must_use]
pub fn counted(experiment: &Experiment, effort: Effort) -> String {
    let mut lines = vec![format!("{} ({} counted)", experiment.name, experiment.work)];
    for curve in (experiment.curves)(effort) {
        for Point {
            knob, work, rms, ..
        } in &curve.points
        {
            let method = curve.method;
            lines.push(format!("{method:24} {knob:>12} {work:>14} {rms:>9.1e}"));
        }
    }
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(points: &[(f64, f64)]) -> Curve<'static> {
        let point = |&(work, error): &(f64, f64)| Point::new(work, work, [error], || 0.0);
        Curve {
            method: "method",
            remark: "",
            slope: None,
            points: points.iter().map(point).collect(),
        }
    }

    const EVERYWHERE: (f64, f64) = (0.0, f64::INFINITY);

    #[test]
    fn errors_have_a_mean_and_a_greatest() {
        let point = Point::new(1.0, 1.0, [3.0, -4.0, 0.0, 0.0], || 0.0);
        assert_eq!((point.rms, point.max), (2.5, 4.0));
    }

    #[test]
    fn the_slope_of_a_power_is_its_exponent() {
        let points: Vec<_> = [1.0, 4.0, 16.0, 64.0, 256.0]
            .map(|n: f64| (n, 0.3 / n.sqrt()))
            .into();
        let slope = curve(&points).fitted_slope(Axis::Work, EVERYWHERE).unwrap();
        assert!((slope + 0.5).abs() < 1e-12, "{slope}");
        let bent = [&[(0.1, 7.0)], points.as_slice(), &[(1e4, 0.3 / 16.0)]].concat();
        let slope = curve(&bent).fitted_slope(Axis::Work, (1.0, 256.0)).unwrap();
        assert!((slope + 0.5).abs() < 1e-12, "{slope}");
    }

    #[test]
    fn a_single_point_and_points_without_error_have_no_slope() {
        assert_eq!(
            curve(&[(1.0, 1.0)]).fitted_slope(Axis::Work, EVERYWHERE),
            None
        );
        let exact = curve(&[(1.0, 0.0), (2.0, 0.0)]);
        assert_eq!(exact.fitted_slope(Axis::Work, EVERYWHERE), None);
    }

    #[test]
    fn the_work_to_an_error_is_read_off_the_curve() {
        let halving = curve(&[(1.0, 0.8), (4.0, 0.4), (16.0, 0.2)]);
        assert_eq!(halving.work_to_reach(1.0), Some((1.0, false)));
        let (work, beyond) = halving.work_to_reach(0.4).unwrap();
        assert!((work - 4.0).abs() < 1e-9 && !beyond);
        let (work, beyond) = halving.work_to_reach(0.1).unwrap();
        assert!((work - 64.0).abs() < 1e-9 && beyond);
        assert_eq!(curve(&[(1.0, 0.5), (9.0, 0.5)]).work_to_reach(0.1), None);
    }

    #[test]
    fn the_front_is_what_nothing_beats() {
        let a = curve(&[(1.0, 0.5), (4.0, 0.3)]);
        let b = curve(&[(2.0, 0.6), (4.0, 0.2)]);
        let front = pareto_front(&[a, b]);
        assert_eq!(front, [[true, false], [false, true]]);
    }

    /// Not all on a line: the errors 10^-1, 10^-1 and 10^-4 at 10, 100 and 1000
    /// have the slope -3/2 by least squares.
    #[test]
    fn the_slope_is_that_of_least_squares() {
        let points = curve(&[(10.0, 1e-1), (100.0, 1e-1), (1000.0, 1e-4)]);
        let slope = points.fitted_slope(Axis::Work, EVERYWHERE).unwrap();
        assert!((slope + 1.5).abs() < 1e-12, "{slope}");
    }

    /// The error falls with the work, from point to point.
    #[test]
    fn between_two_points_the_work_lies_on_the_line_through_both() {
        let bent = curve(&[(1.0, 1.0), (4.0, 0.25), (400.0, 0.0025)]);
        let (work, beyond) = bent.work_to_reach(0.025).unwrap();
        assert!((work - 40.0).abs() < 1e-9 && !beyond, "{work}");
        let (work, _) = bent.work_to_reach(0.5).unwrap();
        assert!((work - 2.0).abs() < 1e-9, "{work}");
    }

    /// As good for the same work is not beaten; less error or less work beats.
    #[test]
    fn equals_do_not_beat_each_other() {
        let a = curve(&[(1.0, 0.5), (2.0, 0.25), (4.0, 0.125)]);
        let b = curve(&[(1.0, 0.5), (2.0, 0.5), (8.0, 0.125)]);
        let front = pareto_front(&[a, b]);
        assert_eq!(front, [[true, true, true], [true, false, false]]);
    }

    fn of_slope(expected: f64, tolerance: f64) -> Experiment<'static> {
        let curves = move |_| {
            let slope = Slope {
                expected,
                tolerance,
                between: EVERYWHERE,
            };
            vec![Curve {
                slope: Some(slope),
                ..curve(&[(1.0, 1.0), (2.0, 0.5), (4.0, 0.25)])
            }]
        };
        Experiment {
            name: "halving",
            about: "",
            knob: "",
            work: "",
            error: "",
            against: Axis::Work,
            curves: Box::new(curves),
        }
    }

    #[test]
    fn slopes_near_those_of_theory_pass() {
        let near = [of_slope(-1.0, 0.01), of_slope(-1.5, 0.6)];
        check_slopes(&near, Effort::Quick);
    }

    #[test]
    #[should_panic(expected = "halving: method: Some(-1")]
    fn other_slopes_fail() {
        check_slopes(&[of_slope(-1.5, 0.4)], Effort::Quick);
    }

    #[test]
    #[should_panic(expected = "no experiments")]
    fn a_stage_without_experiments_fails() {
        check_slopes(&[], Effort::Quick);
    }

    #[test]
    fn points_without_error_do_not_bend_the_slope_of_the_others() {
        let points = curve(&[(1.0, 1.0), (10.0, 0.1), (100.0, 0.0)]);
        let slope = points.fitted_slope(Axis::Work, EVERYWHERE).unwrap();
        assert!((slope + 1.0).abs() < 1e-12, "{slope}");
    }

    #[test]
    fn what_the_last_point_reaches_lies_not_beyond_it() {
        let halving = curve(&[(1.0, 0.8), (4.0, 0.4), (16.0, 0.2)]);
        let (work, beyond) = halving.work_to_reach(0.2).unwrap();
        assert!((work - 16.0).abs() < 1e-9 && !beyond);
    }

    #[test]
    fn knobs_and_work_are_counted_in_lines() {
        let lines = counted(&of_slope(-1.0, 0.0), Effort::Quick);
        let line = |n: f64, error: &str| format!("{:24} {n:>12} {n:>14} {error:>9}", "method");
        let expected = [
            "halving ( counted)".to_owned(),
            line(1.0, "1.0e0"),
            line(2.0, "5.0e-1"),
            line(4.0, "2.5e-1"),
        ];
        assert_eq!(lines, expected.join("\n"));
    }
}
