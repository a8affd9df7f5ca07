//! `Series`: a curve as a plot shows it.

use crate::fit::{End, Fit};
use crate::report::Measured;

/// A curve of a plot.
pub struct Series<'a> {
    /// The name of the method.
    pub name: &'a str,
    /// A remark beside the plot, the slope for example.
    pub remark: String,
    /// The ends of the straight line that has this slope, in the range that it was fitted to.
    pub fitted: Option<[End; 2]>,
    /// The points that have a place on logarithmic axes, or an error of 0.
    pub points: Vec<SeriesPoint>,
    /// The errors of the problem at the same places, where its condition is known.
    pub limit: Vec<LimitPoint>,
}

/// A point of a curve.
pub struct SeriesPoint {
    /// Work or parameter.
    pub x: f64,
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
pub fn by_work<'a>(measured: &Measured<'a>) -> Vec<Series<'a>> {
    let experiment = &measured.experiment;
    let mut all = Vec::new();
    for curve in &measured.curves {
        let (mut points, mut limit) = (Vec::new(), Vec::new());
        for point in &curve.points {
            let x = point.on(experiment.against);
            points.push(SeriesPoint {
                x,
                error: point.errors.rms,
            });
            if let Some(problem) = point.errors.problem {
                let error = problem.error;
                limit.push(LimitPoint { x, error });
            }
        }
        points.retain(has_a_place);
        let fit = experiment.fit(curve).filter(Fit::is_power_law);
        all.push(Series {
            name: curve.method,
            remark: fit.map_or(String::new(), |fit| fit.slope_in_words().replace('-', "−")),
            fitted: fit.map(|fit| fit.ends),
            points,
            limit,
        });
    }
    all
}

fn has_a_place(point: &SeriesPoint) -> bool {
    point.x > 0.0 && point.error.is_finite()
}
