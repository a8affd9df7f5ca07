//! The experiments agree with theory, and their work does not change.

use measure::Effort;
use measure::experiment::{check_slopes, counted};

#[test]
fn slopes_are_those_of_theory() {
    check_slopes(&(a04_intersections::stage().experiments)(), Effort::Quick);
}

#[test]
fn work_and_errors_are_locked() {
    for experiment in (a04_intersections::stage().experiments)() {
        insta::assert_snapshot!(experiment.name, counted(&experiment, Effort::Quick));
    }
}
