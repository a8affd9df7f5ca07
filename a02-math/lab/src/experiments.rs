//! Error against the task's difficulty: the angle between vectors.

mod vectors;

use measure::experiment::Experiment;

pub fn experiments() -> Vec<Experiment<'static>> {
    vec![vectors::angles()]
}
