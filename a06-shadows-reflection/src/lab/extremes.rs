//! The stiff and extreme cases of this stage.

pub mod mirrors;
pub mod self_hits;
mod shadows;

use measure::Effort;
use measure::extremes::Case;

pub fn cases(effort: Effort) -> Vec<Case> {
    let shadows = shadows::cases(effort);
    [shadows, mirrors::cases(), self_hits::cases(effort)].concat()
}
