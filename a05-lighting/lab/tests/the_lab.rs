//! The experiments and extreme cases of the laboratory.

use a05_lab::search::LIGHT;

testing::check_lab! { a05_lab::laboratory() }

/// The protocol squares lengths of 1e200 and of 1e-160, and the lesson does not. A handful of roundings lie between the given numbers and the direction.
#[test]
fn the_worst_direction_is_right() {
    let theirs = LIGHT.worst(LIGHT.protocol);
    assert!(theirs.error > 1e6, "{theirs:?}");
    let ours = LIGHT.worst(LIGHT.lesson);
    assert!(ours.error < 8.0 && ours.lost.is_none(), "{ours:?}");
}
