//! The stiff and extreme cases of this stage: self-hits, shadows, and the light between two
//! mirrors that face each other.

mod between_mirrors;
mod shadows;
mod slope;

use measure::Effort;
use measure::extremes::Case;

pub fn cases(effort: Effort) -> Vec<Case> {
    [shadows::cases(effort), between_mirrors::cases()].concat()
}
