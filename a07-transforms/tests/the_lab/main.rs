//! Tests of `src/lab`: experiments, extreme cases, and the formulas that they measure.
//!
//! `cargo test` runs them after the tests of the lesson, which they measure.

mod errata_rows;
mod protocol;

use measure::experiment::checked;
use measure::{Effort, extremes};

#[test]
fn the_experiments_agree_with_theory_and_do_not_change() {
    for experiment in (a07_transforms::stage().experiments)() {
        insta::assert_snapshot!(experiment.name, checked(&experiment, Effort::Quick));
    }
}

#[test]
fn the_extremes_hold() {
    extremes::check(&(a07_transforms::stage().extremes)(Effort::of_build()));
}
