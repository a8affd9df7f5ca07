//! The experiments: slopes as theory gives them, and the counted work.

use measure::Effort::Quick;
use measure::experiment::{check_slopes, counted};

#[test]
fn slopes_are_those_of_theory() {
    check_slopes(&(a07_transforms::stage().experiments)(), Quick);
}

#[test]
fn work_and_errors_are_locked() {
    for experiment in (a07_transforms::stage().experiments)() {
        insta::assert_snapshot!(experiment.name, counted(&experiment, Quick));
    }
}
