//! Error against run time for transforms and their inverses.

mod inverses;
pub mod nested_nodes;

use measure::experiment::Experiment;

pub fn experiments() -> Vec<Experiment<'static>> {
    let mut all = vec![inverses::nesting(), inverses::condition()];
    all.extend(nested_nodes::experiments());
    all
}
