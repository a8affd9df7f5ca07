//! The experiments of this stage agree with theory, and give the same numbers on
//! every machine.

use measure::Effort;
use measure::experiment::{check_slopes, counted};

#[test]
fn slopes_are_those_of_theory() {
    check_slopes(&(a03_rays_cameras::stage().experiments)(), Effort::Quick);
}

#[test]
fn errors_and_work_are_the_same_everywhere() {
    for experiment in (a03_rays_cameras::stage().experiments)() {
        insta::assert_snapshot!(experiment.name, counted(&experiment, Effort::Quick));
    }
}
