//! Curves and experiments with known points, for the tests of this crate.

use common::{Scene, Stage};

use crate::Laboratory;
use crate::experiment::{Curve, Errors, Experiment, Point, Slope, Times};

/// A curve with a point for each pair of work, which is also the parameter, and error.
pub fn curve(points: &[(f64, f64)]) -> Curve<'static> {
    let point = |(work, error): &(f64, f64)| Point {
        parameter: *work,
        work: *work,
        errors: Errors::of([*error]),
        times: Times::of(|| ()),
    };
    Curve::new("a < b", points.iter().map(point))
}

/// A curve of three errors that fall as one over the square root.
pub fn falling() -> Curve<'static> {
    Curve {
        slope: Some(Slope {
            value: -0.5,
            between: 1.0..=1e9,
        }),
        ..curve(&[(1.0, 1.0), (16.0, 0.25), (256.0, 0.0625)])
    }
}

/// An experiment with this curve.
pub fn experiment() -> Experiment<'static> {
    Experiment {
        question: "Is the error one over the square root?",
        parameter: "n",
        work: "steps",
        error: "rms error",
        exact: "against 0",
        seeds: &[3, 4],
        curves: Box::new(|| vec![falling()]),
        ..Experiment::new("square-root")
    }
}

/// A laboratory without experiments and cases, of a stage with these scenes.
pub fn laboratory(scenes: Vec<Scene>) -> Laboratory {
    Laboratory {
        stage: Stage {
            name: "a00",
            about: "",
            scenes,
            open: None,
        },
        experiments: Vec::new,
        extremes: |_| Vec::new(),
    }
}
