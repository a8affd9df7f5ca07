//! `check_lab!`: the tests of the experiments and extreme cases of a stage.

/// Writes these tests: the curves of the experiments have the slopes of theory and are
/// locked as text, and no extreme case is out of its bound.
///
/// Curves that depend on rounding are not locked. A line `"name" => check` names such an
/// experiment and a function that checks its curves.
///
/// The crate of the tests needs `insta` and `measure`.
#[macro_export]
macro_rules! check_lab {
    ($stage:expr $(; $unlocked:literal => $check:path)?) => {
        #[test]
        fn the_experiments_agree_with_theory_and_do_not_change() {
            use measure::{Effort, experiment::checked};
            for experiment in ($stage.experiments)() {
                match experiment.name {
                    $($unlocked => $check(&(experiment.curves)(Effort::Quick)),)?
                    name => insta::assert_snapshot!(name, checked(&experiment, Effort::Quick)),
                }
            }
        }

        #[test]
        fn the_extremes_hold() {
            use measure::{Effort, extremes};
            extremes::check(&($stage.extremes)(Effort::of_build()));
        }
    };
}
