//! Tests of `src/lab`: experiments, extreme cases, and the formulas that they measure.
//!
//! `cargo test` runs them after the tests of the lesson, which they measure.

mod protocol;
mod recursion_depth;

use measure::experiment::{Curve, checked};
use measure::{Effort, extremes};

#[test]
fn the_experiments_agree_with_theory_and_do_not_change() {
    for experiment in (a06_shadows_reflection::stage().experiments)() {
        if experiment.name == "shadow-epsilon" {
            only_the_offset_origin_is_never_wrong(&(experiment.curves)(Effort::Quick));
        } else {
            insta::assert_snapshot!(experiment.name, checked(&experiment, Effort::Quick));
        }
    }
}

/// How often a bound fails depends on rounding, and is not locked; that ours never fails,
/// and every other somewhere, is.
fn only_the_offset_origin_is_never_wrong(curves: &[Curve]) {
    let (ours, others) = curves.split_last().unwrap();
    assert!(ours.points.iter().all(|point| point.max == 0.0));
    for curve in others {
        let is_wrong = curve.points.iter().any(|point| point.max > 0.0);
        assert!(is_wrong, "{}", curve.method);
    }
}

#[test]
fn the_extremes_hold() {
    extremes::check(&(a06_shadows_reflection::stage().extremes)(
        Effort::of_build(),
    ));
}
