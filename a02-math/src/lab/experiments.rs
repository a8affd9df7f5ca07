//! Error against the task's difficulty: angles, linear systems, and lengths.
//!
//! The inputs are numbers with few binary digits, so that the solution is known
//! exactly and only the method rounds.

mod angles;
mod lengths;
mod systems;
mod whole_numbers;

use measure::experiment::Experiment;

pub use systems::refined;

pub fn experiments() -> Vec<Experiment<'static>> {
    vec![
        angles::experiment(),
        systems::experiment(),
        lengths::experiment(),
    ]
}
