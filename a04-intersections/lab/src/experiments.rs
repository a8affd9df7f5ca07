//! Error against run time of the intersection formulas.

pub mod needle;
pub mod sphere_distance;

use measure::experiment::Experiment;

pub fn experiments() -> Vec<Experiment<'static>> {
    vec![
        sphere_distance::far(),
        sphere_distance::near(),
        needle::experiment(),
    ]
}
