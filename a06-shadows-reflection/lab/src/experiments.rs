//! Error against run time for shadows.

pub mod secondary_rays;
mod shadow_terminator;

use measure::experiment::Experiment;

pub fn experiments() -> Vec<Experiment<'static>> {
    let mut all = secondary_rays::experiments();
    all.push(shadow_terminator::experiment());
    all
}
