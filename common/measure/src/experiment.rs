//! Error against work: the price of a smaller error.
//!
//! As in work-precision diagrams of solvers of differential equations, several
//! methods solve one problem with a parameter that goes from coarse to fine. Each
//! value is a point of the diagram: the error, and its price. The price is counted,
//! which is the same on every machine, and timed, which is not.

use crate::Effort;

/// Half a grey level of an 8-bit picture: smaller errors can't be seen.
pub const HALF_GREY_LEVEL: f64 = 1.0 / 510.0;

/// The horizontal axis against which the slopes of an experiment are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The counted work, where the parameter changes the price of the method.
    Work,
    /// The parameter itself, where it changes the problem and not the method.
    Knob,
}

/// A comparison of methods.
pub struct Experiment<'a> {
    /// The name on the command line, in kebab case.
    pub name: &'a str,
    /// The question, in one line.
    pub about: &'a str,
    /// The name of the parameter.
    pub knob: &'a str,
    /// The unit of the counted work, such as rays.
    pub work: &'a str,
    /// The quantity that the error is of, and its exact value.
    pub error: &'a str,
    /// The axis that slopes are taken against.
    pub against: Axis,
    /// Measures all methods. The first is the baseline of the times.
    pub curves: Box<dyn Fn(Effort) -> Vec<Curve<'a>> + 'a>,
}

/// A method at all values of the parameter.
pub struct Curve<'a> {
    /// Its name.
    pub method: &'a str,
    /// A remark for the reader: for the most exact method, why it is not in the
    /// renderer. May be empty.
    pub remark: &'a str,
    /// The slope that theory gives, if it gives one.
    pub slope: Option<Slope>,
    /// The measurements, from coarse to fine.
    pub points: Vec<Point<'a>>,
}

/// A slope of log error over log work, or over the log of the parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// The slope that theory gives.
    pub expected: f64,
    /// The largest deviation of a measured slope.
    pub tolerance: f64,
    /// The range of the axis in which points count: below it, theory may not hold
    /// yet, and above it, rounding errors may be larger.
    pub between: (f64, f64),
}

/// One measurement.
pub struct Point<'a> {
    /// The value of the parameter.
    pub knob: f64,
    /// The counted work.
    pub work: f64,
    /// The root mean square error.
    pub rms: f64,
    /// The greatest error.
    pub max: f64,
    /// The work itself, to be timed, without the measurement of the error. Its
    /// result is used, so that the compiler cannot remove the work.
    pub run: Box<dyn FnMut() -> f64 + 'a>,
}

impl<'a> Point<'a> {
    /// A measurement with these errors, at least one.
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

    /// The coordinate on an axis.
    #[must_use]
    pub const fn on(&self, axis: Axis) -> f64 {
        match axis {
            Axis::Work => self.work,
            Axis::Knob => self.knob,
        }
    }
}

impl Curve<'_> {
    /// The slope of log error over log `axis` for the points in a range, by least
    /// squares. None if fewer than two of them have an error.
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

    /// The work that brings the error down to `target`. Between two points it is
    /// interpolated on the straight line through both. Beyond the last point it is
    /// extrapolated on the fitted line, and the flag is true. None if the error
    /// does not fall.
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

/// The Pareto front, by curve and point: true for a point if no other has both
/// less work and a smaller error.
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
/// agree with theory.
///
/// # Panics
///
/// If a slope does not; the message lists all of them.
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

/// The counted work of every point, for a snapshot, because it is the same on every
/// machine. The errors are rounded to two digits.
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
mod tests;
