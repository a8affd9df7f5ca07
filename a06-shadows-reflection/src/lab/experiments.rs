//! Error against run time for mirrors and shadows.

mod recursion_depth;
mod shadow_epsilon;

use measure::experiment::Experiment;

pub fn experiments() -> Vec<Experiment<'static>> {
    vec![recursion_depth::experiment(), shadow_epsilon::experiment()]
}
