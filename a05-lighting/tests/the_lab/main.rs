//! Tests of `src/lab`: experiments, extreme cases, and the formulas that they measure.
//!
//! `cargo test` runs them after the tests of the lesson, which they measure.

mod protocol;

use measure::experiment::checked;
use measure::{Effort, extremes};

#[test]
fn the_experiments_agree_with_theory_and_do_not_change() {
    for experiment in (a05_lighting::stage().experiments)() {
        let counted = checked(&experiment, Effort::Quick);
        if experiment.name != "spot-rim" {
            insta::assert_snapshot!(experiment.name, counted);
        }
    }
}

/// How many points beside the rim are judged wrongly depends on rounding, and is not
/// locked; where the errors begin is.
#[test]
fn only_the_arc_cosine_is_wrong_a_billionth_beside_the_rim() {
    let experiments = (a05_lighting::stage().experiments)();
    let rim = experiments.iter().find(|e| e.name == "spot-rim").unwrap();
    let curves = (rim.curves)(Effort::Quick);
    let (protocol, others) = curves.split_first().unwrap();
    assert!(protocol.points.iter().all(|point| point.max > 0.01));
    for curve in others {
        let mut far = curve.points.iter().filter(|point| point.knob >= 1e-9);
        assert!(far.all(|point| point.max == 0.0), "{}", curve.method);
    }
}

#[test]
fn the_extremes_hold() {
    extremes::check(&(a05_lighting::stage().extremes)(Effort::of_build()));
}
