//! The experiments: slopes as theory gives them, and the counted work.

use common::Effort::Quick;
use common::experiment::{check_slopes, counted};

#[test]
fn slopes_are_those_of_theory() {
    for experiment in (a05_lighting::stage().experiments)() {
        check_slopes(&experiment, Quick);
    }
}

#[test]
fn work_and_errors_are_locked() {
    for experiment in (a05_lighting::stage().experiments)() {
        insta::assert_snapshot!(experiment.name, counted(&experiment, Quick));
    }
}
