//! Curves and experiments with known points, for the tests of this crate.

use common::{Scene, Stage};

use crate::Laboratory;
use crate::experiment::{Axis, Curve, Experiment, Point};

/// A curve with a point for each pair of work, which is also the parameter, and error.
pub fn curve(points: &[(f64, f64)]) -> Curve<'static> {
    let point = |&(work, error): &(f64, f64)| Point::new(work, work, [error], move || work);
    Curve::new("a < b", points.iter().map(point))
}

/// An experiment with one curve: three errors that fall as one over the square root.
pub fn experiment() -> Experiment<'static> {
    Experiment::new("square-root")
        .asking("Is the error one over the square root?")
        .over(Axis::Work, "n", "steps")
        .with_error("rms error")
        .with_exact("against 0")
        .with_seeds(&[3, 4])
        .with_curves(|_| {
            let falling = curve(&[(1.0, 1.0), (16.0, 0.25), (256.0, 0.0625)]);
            let falling = falling.with_slope(-0.5, (1.0, 1e9));
            vec![falling]
        })
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
        search: None,
    }
}
