//! `check_lab!`: the tests of the experiments and extreme cases of a stage.

/// Writes these tests: the curves of the experiments have the slopes and bounds of theory,
/// and no extreme case is out of its bound. The crate of the tests needs `measure`.
#[macro_export]
macro_rules! check_lab {
    ($laboratory:expr) => {
        #[test]
        fn the_experiments_agree_with_theory() {
            use measure::experiment::check;
            for experiment in ($laboratory.experiments)() {
                check(&experiment);
            }
        }

        #[test]
        fn the_extremes_hold() {
            use measure::{Effort, extremes};
            extremes::check(&($laboratory.extremes)(Effort::of_build()));
        }
    };
}
