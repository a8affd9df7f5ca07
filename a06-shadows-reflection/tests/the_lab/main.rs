//! Tests of `src/lab`: experiments, extreme cases, and the formulas that they measure.
//!
//! `cargo test` runs them after the tests of the lesson, which they measure.

mod protocol;

use measure::experiment::Curve;

testing::check_lab! {
    a06_shadows_reflection::stage(); "shadow-epsilon" => only_the_offset_origin_is_never_wrong
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
