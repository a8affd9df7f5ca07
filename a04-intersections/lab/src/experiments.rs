//! Error against run time of the intersection formulas.

pub mod far_sphere;
pub mod needle;

use measure::experiment::Experiment;

pub fn experiments() -> Vec<Experiment<'static>> {
    vec![far_sphere::experiment(), needle::experiment()]
}
