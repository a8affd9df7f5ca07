//! Stiff and extreme cases of cameras, samples and stripes.

mod cameras;
mod samples;
mod stripes;

use a02_math::Vector3;
use measure::Effort;
use measure::extremes::Case;

pub fn cases(_: Effort) -> Vec<Case> {
    [cameras::cases(), samples::cases(), stripes::cases()].concat()
}

const AHEAD: Vector3 = Vector3::new(0.0, 0.0, -1.0);
const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
