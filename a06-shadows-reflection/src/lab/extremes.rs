//! The stiff and extreme cases of this stage.

pub mod mirrors;
pub mod self_hits;
mod shadows;
mod slopes;

use measure::Effort;
use measure::extremes::Case;

pub fn cases(effort: Effort) -> Vec<Case> {
    let rows = [shadows::cases(), slopes::cases(effort), mirrors::cases()];
    [rows.concat(), self_hits::cases(effort)].concat()
}
