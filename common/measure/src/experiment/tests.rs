use super::*;
use crate::example::{curve, experiment};

#[test]
fn the_mean_and_the_greatest_error_are_computed() {
    let point = Point::new(1.0, 1.0, [3.0, -4.0, 0.0, 0.0], || 0.0);
    assert_eq!((point.rms, point.max), (2.5, 4.0));
}

/// A point with the same error and the same work does not beat another; a smaller
/// error or less work does.
#[test]
fn the_front_has_the_points_that_no_other_beats() {
    let a = curve(&[(1.0, 0.5), (2.0, 0.25), (4.0, 0.125)]);
    let b = curve(&[(1.0, 0.5), (2.0, 0.5), (8.0, 0.125)]);
    let front = pareto_front(&[a, b]);
    let expected = [&[true; 3][..], &[true, false, false]];
    assert_eq!(front, expected);
}

#[test]
fn half_a_grey_level_is_a_mark_for_light_that_work_improves() {
    let mut experiment = experiment();
    let falling = [curve(&[(1.0, 0.5), (9.0, 0.1)])];
    let rising = [curve(&[(1.0, 0.1), (9.0, 0.5)])];
    assert!(experiment.can_be_seen(&falling) && !experiment.can_be_seen(&rising));
    experiment.unit = Unit::Other("radii");
    assert!(!experiment.can_be_seen(&falling));
}

/// The slope is -1/2, and the errors at 1, 16 and 256 are 1, 1/4 and 1/16.
#[test]
fn slopes_and_bounds_are_checked_and_shares_have_no_slope() {
    let is_right = |unit, change: fn(Curve<'static>) -> Curve<'static>| {
        let curves = move |_| {
            let curves = (experiment().curves)(Effort::Quick).into_iter();
            curves.map(change).collect()
        };
        let experiment = experiment().with_unit(unit).with_curves(curves);
        let check = || check(&experiment, Effort::Quick);
        std::panic::catch_unwind(std::panic::AssertUnwindSafe(check)).is_ok()
    };
    assert!(is_right(Unit::Light, |curve| curve.with_slope(-0.54, (0.0, 1e9))));
    assert!(!is_right(Unit::Light, |curve| curve.with_slope(-0.44, (0.0, 1e9))));
    assert!(
        !is_right(Unit::Share, |curve| curve),
        "fractions have a largest value"
    );
    assert!(is_right(Unit::Light, |curve| curve.with_bound(0.25, 16.0..=1e9)));
    assert!(!is_right(Unit::Light, |curve| curve.with_bound(0.249, 16.0..=1e9)));
}
