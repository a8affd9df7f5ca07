//! The rounding error of a picture, over the depth of its reflections.

use std::rc::Rc;

use a04_lab::line::Line;
use common::Size;
use measure::Effort;
use measure::experiment::{Axis, Curve, Curves, Experiment, TaskSet};

use crate::digits::{NO_OFFSET, OFFSET, error, lines, spread};

/// Each surface adds the rounding errors of its hit to those of the ray that leaves it, and its
/// reflectance takes a half of them.
pub fn experiment() -> Experiment<'static> {
    Experiment {
        question: "How exact is a pixel of the scene sphere?",
        curves_are: Curves::Problems,
        parameter: "depth",
        work: "pixels",
        against: Axis::Parameter,
        error: "rms error of the worst channel",
        exact: "against 31 digits; or the greatest difference of 8 runs",
        curves: Box::new(curves),
        ..Experiment::new("pixel-rounding")
    }
}

/// A ray with its number and the depth of its reflections.
struct Pixel {
    line: Line,
    depth: u32,
    n: u64,
}

fn curves(effort: Effort) -> Vec<Curve<'static>> {
    let width = effort.choose(48, 96) as u32;
    let lines = Size::new(width, width / 4 * 3)
        .map_err(Into::into)
        .and_then(lines)
        .unwrap_or_default();
    let mut sets = Vec::new();
    for depth in [1, 2, 3, 6] {
        let mut pixels = Vec::new();
        for (n, line) in (0..).zip(&lines) {
            let line = *line;
            pixels.push(Pixel { line, depth, n });
        }
        let tasks: Rc<[Pixel]> = pixels.into();
        sets.push(TaskSet {
            parameter: f64::from(depth),
            tasks,
        });
    }
    let curve = |name, error: fn(&Pixel) -> f64| {
        Curve::of_tasks(name, &sets, error, |_, error: f64| [error])
    };
    vec![
        curve("rounding error", |pixel| {
            error(&pixel.line, pixel.depth, OFFSET)
        }),
        curve("random rounding, 8 runs", |pixel| {
            spread(&pixel.line, pixel.depth, pixel.n)
        }),
        curve("rounding and offset", |pixel| {
            error(&pixel.line, pixel.depth, NO_OFFSET)
        }),
    ]
}
