//! The experiments: slopes as theory gives them, and the counted work.

use measure::Effort::Quick;
use measure::experiment::{Experiment, check_slopes, counted};

fn experiment(name: &str) -> Experiment<'static> {
    let experiments = (a06_shadows_reflection::stage().experiments)();
    experiments.into_iter().find(|e| e.name == name).unwrap()
}

#[test]
fn the_error_between_mirrors_is_the_one_asked_for() {
    let experiment = [experiment("recursion-depth")];
    check_slopes(&experiment, Quick);
    insta::assert_snapshot!(experiment[0].name, counted(&experiment[0], Quick));
}

/// How often a bound fails is luck of rounding, and not locked; that ours never
/// does, and every other somewhere, is.
#[test]
fn only_a_lift_along_the_normal_is_never_wrong() {
    let curves = (experiment("shadow-epsilon").curves)(Quick);
    let (ours, others) = curves.split_last().unwrap();
    assert!(ours.points.iter().all(|point| point.max == 0.0));
    for curve in others {
        let method = curve.method;
        assert!(curve.points.iter().any(|point| point.max > 0.0), "{method}");
    }
}
