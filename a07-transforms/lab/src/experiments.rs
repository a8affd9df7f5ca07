//! Error against run time for transforms and their inverses.

mod inverses;

use measure::experiment::Experiment;

pub fn experiments() -> Vec<Experiment<'static>> {
    vec![inverses::experiment()]
}
