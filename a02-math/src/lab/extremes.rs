//! Stiff and extreme cases of vectors, angles and linear systems. Exact values
//! are computed from the given doubles, with 60 digits or with fractions.

mod angles;
mod lengths;
mod systems;

use measure::Effort;
use measure::extremes::Case;

use crate::Vector3;

/// All rows.
pub fn cases(_: Effort) -> Vec<Case> {
    let mut cases = lengths::cases();
    cases.extend(angles::cases());
    cases.extend(systems::cases());
    cases
}

const fn vector([x, y, z]: [f64; 3]) -> Vector3 {
    Vector3::new(x, y, z)
}

fn triple(v: Vector3) -> [f64; 3] {
    v.to_glam().to_array()
}
