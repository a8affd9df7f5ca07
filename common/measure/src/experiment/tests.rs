use super::*;
use std::ops::RangeInclusive;

use crate::example::{experiment, falling};

#[test]
fn the_mean_and_the_greatest_error_are_computed() {
    let errors = Errors::of([3.0, -4.0, 0.0, 0.0]);
    assert_eq!((errors.rms, errors.max), (2.5, Some(4.0)));
}

/// Whether an experiment with these curves agrees with theory.
fn agrees(unit: Unit<'static>, curve: fn() -> Curve<'static>) -> bool {
    let experiment = Experiment {
        unit,
        curves: Box::new(move || vec![curve()]),
        ..experiment()
    };
    let check = || check(&experiment);
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(check)).is_ok()
}

fn with_slope(value: f64) -> Curve<'static> {
    let between = 0.0..=1e9;
    Curve {
        slope: Some(Slope { value, between }),
        ..falling()
    }
}

fn with_bound(error: f64, between: RangeInclusive<f64>) -> Curve<'static> {
    Curve {
        bound: Some(ErrorBound { error, between }),
        ..falling()
    }
}

/// The slope is -1/2, and the errors at 1, 16 and 256 are 1, 1/4 and 1/16.
#[test]
fn slopes_and_bounds_are_checked_and_fractions_have_no_slope() {
    assert!(agrees(Unit::Light, || with_slope(-0.54)));
    assert!(!agrees(Unit::Light, || with_slope(-0.44)));
    assert!(
        !agrees(Unit::Fraction, falling),
        "fractions have a largest value"
    );
    assert!(agrees(Unit::Light, || with_bound(0.25, 16.0..=1e9)));
    assert!(!agrees(Unit::Light, || with_bound(0.249, 16.0..=1e9)));
}

/// Of four answers, one is wrong and another is half wrong.
#[test]
fn the_error_of_decisions_is_the_fraction_of_wrong_ones() {
    let sets = [TaskSet {
        parameter: 1.0,
        tasks: [0.0, 1.0, 0.5, 0.0].into(),
    }];
    let curve = Curve::of_decisions("", &sets, |task: &f64| *task, |_, answer| answer);
    let [Point { errors, .. }] = &curve.points[..] else {
        panic!("one point");
    };
    assert_eq!(*errors, Errors::fraction(0.375, 4));
}
