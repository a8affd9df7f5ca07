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
mod tests;
