//! `Series`: a curve as a plot shows it.

use common::Median;

use crate::experiment::{Curve, Experiment};
use crate::report::Measured;

/// A curve of a plot.
pub struct Series<'a> {
    /// The name of the method.
    pub name: &'a str,
    /// A remark beside the plot, the slope for example.
    pub remark: String,
    /// The points that have a place on logarithmic axes, or an error of 0.
    pub points: Vec<SeriesPoint>,
    /// The errors of the problem at the same places, where its condition is known.
    pub limit: Vec<LimitPoint>,
}

/// A point of a curve.
pub struct SeriesPoint {
    /// Work, parameter or time.
    pub x: f64,
    /// The ends of the interval that holds it.
    pub low: f64,
    pub high: f64,
    pub error: f64,
}

/// The error that the problem itself has.
#[derive(PartialEq)]
pub struct LimitPoint {
    /// Work or parameter.
    pub x: f64,
    pub error: f64,
}

/// The curves against work or parameter, with their slopes.
pub fn by_work<'a>(measured: &Measured<'_, 'a>) -> Vec<Series<'a>> {
    let experiment = measured.experiment;
    let mut all = Vec::new();
    for curve in &measured.curves {
        let (mut points, mut limit) = (Vec::new(), Vec::new());
        for point in &curve.points {
            let x = point.on(experiment.against);
            points.push(SeriesPoint {
                x,
                low: x,
                high: x,
                error: point.errors.rms,
            });
            if let Some(problem) = point.errors.problem {
                let error = problem.error;
                limit.push(LimitPoint { x, error });
            }
        }
        points.retain(has_a_place);
        all.push(Series {
            name: curve.method,
            remark: slope(experiment, curve),
            points,
            limit,
        });
    }
    all
}

/// The points against time that can be compared with those of other methods.
pub fn by_time<'a>(measured: &Measured<'_, 'a>) -> Vec<Series<'a>> {
    let mut all = Vec::new();
    for curve in &measured.curves {
        let mut points = Vec::new();
        for contender in measured.contenders(curve) {
            let Median { low, value, high } = contender.time;
            points.push(SeriesPoint {
                x: value,
                low,
                high,
                error: contender.error,
            });
        }
        points.retain(has_a_place);
        if !points.is_empty() {
            all.push(Series {
                name: curve.method,
                remark: String::new(),
                points,
                limit: Vec::new(),
            });
        }
    }
    all
}

fn has_a_place(point: &SeriesPoint) -> bool {
    point.low > 0.0 && point.error.is_finite()
}

/// The slope in words, if the errors follow a power law.
fn slope(experiment: &Experiment, curve: &Curve) -> String {
    match experiment.fit(curve) {
        Some(fit) if fit.is_power_law() => fit.slope_in_words().replace('-', "−"),
        _ => String::new(),
    }
}
