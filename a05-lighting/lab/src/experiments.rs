//! Error against run time for lights and materials.

mod facets;
mod phong;

use measure::experiment::Experiment;

pub fn experiments() -> Vec<Experiment<'static>> {
    vec![facets::experiment(), phong::power()]
}
