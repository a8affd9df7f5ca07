//! Error against run time for mirrors and shadows.

mod recursion_depth;
pub mod secondary_rays;
mod shadow_terminator;

use measure::experiment::Experiment;

pub fn experiments() -> Vec<Experiment<'static>> {
    let mut all = vec![recursion_depth::experiment()];
    all.extend(secondary_rays::experiments());
    all.push(shadow_terminator::experiment());
    all
}
