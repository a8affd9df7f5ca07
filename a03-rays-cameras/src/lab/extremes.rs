//! Stiff and extreme cases of cameras, samples and stripes.

mod axes;
mod cameras;
mod pinhole;
mod samples;
mod stripes;

use a02_math::Vector3;
use measure::Effort;
use measure::extremes::Case;

/// All rows.
pub fn cases(_: Effort) -> Vec<Case> {
    let mut cases = cameras::cases();
    cases.extend(axes::cases());
    cases.extend(pinhole::cases());
    cases.extend(samples::cases());
    cases.extend(stripes::cases());
    cases
}

const AHEAD: Vector3 = Vector3::new(0.0, 0.0, -1.0);
const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

fn triple(v: Vector3) -> [f64; 3] {
    v.to_glam().to_array()
}
