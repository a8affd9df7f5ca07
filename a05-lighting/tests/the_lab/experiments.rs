//! The experiments: slopes as theory gives them, and the counted work.

use measure::Effort::Quick;
use measure::experiment::{check_slopes, counted};

#[test]
fn slopes_are_those_of_theory() {
    check_slopes(&(a05_lighting::stage().experiments)(), Quick);
}

#[test]
fn work_and_errors_are_locked() {
    for experiment in (a05_lighting::stage().experiments)() {
        if experiment.name != "spot-rim" {
            insta::assert_snapshot!(experiment.name, counted(&experiment, Quick));
        }
    }
}

/// How many points are judged wrongly beside the rim is luck of rounding, and
/// not locked; where it begins is.
#[test]
fn only_the_arc_cosine_is_wrong_a_billionth_beside_the_rim() {
    let experiments = (a05_lighting::stage().experiments)();
    let rim = experiments.iter().find(|e| e.name == "spot-rim").unwrap();
    let curves = (rim.curves)(Quick);
    let (protocol, others) = curves.split_first().unwrap();
    assert!(protocol.points.iter().all(|point| point.max > 0.01));
    for curve in others {
        let mut far = curve.points.iter().filter(|point| point.knob >= 1e-9);
        assert!(far.all(|point| point.max == 0.0), "{}", curve.method);
    }
}
