//! Error against run time for lights and materials.

mod lambert_phase;
mod phong_mean;
mod phong_power;
mod spot_rim;

use measure::experiment::Experiment;

pub fn experiments() -> Vec<Experiment<'static>> {
    vec![
        lambert_phase::experiment(),
        phong_mean::experiment(),
        phong_power::experiment(),
        spot_rim::experiment(),
    ]
}
