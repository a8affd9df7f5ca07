//! The plots of an experiment: error against its work or parameter, and error against time.

mod axis;
mod diagram;

use common::{Median, text};

use crate::experiment::{Axis, Curve, Curves, Interval, Point};
use crate::report::Measured;
pub use diagram::{Diagram, Line, Mark};

/// A plot as a file.
pub struct Plot {
    /// The ending of its name, behind those of stage and experiment.
    pub ending: &'static str,
    /// The text of the file.
    pub svg: String,
}

/// A unit of time, in seconds.
struct TimeUnit {
    name: &'static str,
    seconds: f64,
}

const TIME_UNITS: [TimeUnit; 4] = [
    TimeUnit {
        name: "s",
        seconds: 1.0,
    },
    TimeUnit {
        name: "ms",
        seconds: 1e-3,
    },
    TimeUnit {
        name: "µs",
        seconds: 1e-6,
    },
    TimeUnit {
        name: "ns",
        seconds: 1e-9,
    },
];

/// The plots of an experiment: error against work or parameter, and error against time, or against
/// the opposite mistake if there is one.
pub fn plots(measured: &Measured, opposite: Option<&Measured>) -> [Plot; 2] {
    let against_time = match opposite {
        Some(opposite) => of_mistakes(measured, opposite),
        None => by_time(measured),
    };
    let names: Vec<_> = measured.curves.iter().map(|curve| curve.method).collect();
    [
        Plot {
            ending: ".svg",
            svg: by_work(measured).draw(&names),
        },
        Plot {
            ending: "-time.svg",
            svg: against_time.draw(&names),
        },
    ]
}

/// Error against counted work or the parameter.
fn by_work(measured: &Measured) -> Diagram {
    let e = &measured.experiment;
    let marks = measured.points().map(|(curve, point)| {
        let x = point.on(e.against);
        Mark::new(curve, [x; 3], point)
    });
    Diagram {
        title: e.question.to_owned(),
        remark: e.exact.to_owned(),
        x: match e.against {
            Axis::Work => e.work.to_owned(),
            Axis::Parameter => e.parameter.to_owned(),
        },
        y: format!("{} ({})", e.error, e.unit),
        is_wide: true,
        has_curves: true,
        marks: marks.collect(),
        lines: Vec::new(),
    }
}

/// Error against time. Where the parameter changes the problem, a curve leads from easy problems to
/// hard ones.
fn by_time(measured: &Measured) -> Diagram {
    let e = &measured.experiment;
    let unit = time_unit(measured);
    let marks = measured.points().map(|(curve, point)| {
        let Median { low, value, high } = point.times.seconds;
        let ends = [low, value, high].map(|seconds| seconds / unit.seconds);
        Mark::new(curve, ends, point)
    });
    let task = match size_of_task(measured) {
        Some(work) => format!(" for {} {}", text::rounded(work, 5), e.work),
        None => String::new(),
    };
    Diagram {
        title: e.question.to_owned(),
        remark: String::new(),
        x: format!("processor time{task} ({})", unit.name),
        y: format!("{} ({})", e.error, e.unit),
        is_wide: e.against == Axis::Parameter && e.curves_are == Curves::Methods,
        has_curves: true,
        marks: marks.collect(),
        lines: Vec::new(),
    }
}

/// The greatest fractions of two opposite mistakes.
fn of_mistakes(measured: &Measured, opposite: &Measured) -> Diagram {
    let greatest = |curve: &Curve| {
        let points = curve.points.iter().map(|point| point.errors);
        points.max_by(|a, b| a.rms.total_cmp(&b.rms))
    };
    let mut marks = Vec::new();
    for (index, curve) in measured.curves.iter().enumerate() {
        let other = opposite.curve(curve.method).and_then(greatest);
        if let (Some(x), Some(y)) = (greatest(curve), other) {
            marks.push(Mark {
                curve: index,
                x: x.rms,
                x_ends: x.interval,
                y: y.rms,
                y_ends: y.interval,
            });
        }
    }
    Diagram {
        title: measured.experiment.question.to_owned(),
        remark: String::new(),
        x: measured.experiment.error.to_owned(),
        y: opposite.experiment.error.to_owned(),
        is_wide: false,
        has_curves: false,
        marks,
        lines: Vec::new(),
    }
}

impl Mark {
    /// The error of a point of a curve, at these coordinates: the low end, the value, the high end.
    const fn new(curve: usize, [low, x, high]: [f64; 3], point: &Point) -> Self {
        Self {
            curve,
            x,
            x_ends: Interval { low, high },
            y: point.errors.rms,
            y_ends: point.errors.interval,
        }
    }
}

/// The greatest unit in which no time is below 1; else nanoseconds.
fn time_unit(measured: &Measured) -> &'static TimeUnit {
    let times = measured
        .points()
        .map(|(_, point)| point.times.seconds.value);
    let least = times.fold(f64::INFINITY, f64::min);
    let is_enough = |unit: &&TimeUnit| least >= unit.seconds;
    TIME_UNITS.iter().find(is_enough).unwrap_or(&TIME_UNITS[3])
}

/// The work of all points, if it is the same.
fn size_of_task(measured: &Measured) -> Option<f64> {
    let (_, first) = measured.points().next()?;
    let is_same = measured.points().all(|(_, point)| point.work == first.work);
    is_same.then_some(first.work)
}

#[cfg(test)]
mod tests;
