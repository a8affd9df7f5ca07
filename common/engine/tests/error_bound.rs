//! The promise of adaptive sampling, checked against true errors for one variant of each kind
//! of the benchmark `error_bound`, which checks more.

#[path = "../benches/error_bound/kinds.rs"]
mod kinds;
#[path = "../src/adaptive/random.rs"]
mod random;
#[path = "../benches/error_bound/scenes.rs"]
mod scenes;
#[path = "../benches/error_bound/stratified.rs"]
mod stratified;
#[path = "../benches/error_bound/trial.rs"]
mod trial;
#[path = "../benches/error_bound/tuned.rs"]
mod tuned;
#[path = "../benches/error_bound/unseen.rs"]
mod unseen;

use common::Size;

use crate::trial::Subject;

/// With 95 % confidence, one or two of 38 pictures may be above the bound.
#[test]
fn pictures_keep_their_bound_or_say_that_they_may_not() {
    let size = Size::new(48, 36).unwrap();
    let kinds = tuned::TUNED
        .iter()
        .chain(&unseen::UNSEEN)
        .chain(&scenes::SCENES);
    let mut silent = Vec::new();
    for kind in kinds {
        let subject = Subject::new(kind, 3, size, 24);
        for bound in [1.0 / 64.0, 1.0 / 255.0] {
            let trial = subject.trial(bound, 0, &[]).unwrap();
            assert!(
                trial.error < 1.5 || trial.is_said,
                "{}: {}",
                kind.name,
                trial.error
            );
            if trial.is_silent() {
                silent.push((kind.name, trial.error));
            }
        }
    }
    assert!(silent.len() <= 2, "{silent:?}");
}

/// Stratified sampling is measured in the benchmark only.
#[test]
fn samples_of_stratified_sampling_are_compared_at_equal_errors() {
    let size = Size::new(32, 24).unwrap();
    let subject = Subject::new(&tuned::TUNED[0], 0, size, 16);
    let uniform = subject.uniform();
    assert!(uniform.windows(2).all(|pair| pair[1].1 < pair[0].1));
    let trial = subject.trial(1.0 / 64.0, 0, &uniform).unwrap();
    assert!(trial.uniform > 1.0 && trial.samples >= 4.0);
}
