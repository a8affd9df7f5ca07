//! The depth of recursion that an error needs.

use a06_shadows_reflection::lab::experiments::recursion_depth::{CURVES, depth};
use measure::experiment::HALF_GREY_LEVEL;

#[test]
fn the_depth_is_the_least_that_reaches_half_a_grey_level() {
    let depths = CURVES.map(|(k, _)| depth(k, HALF_GREY_LEVEL));
    assert_eq!(depths, [10, 36, 82, 180, 1079]);
}
