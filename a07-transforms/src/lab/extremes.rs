//! The stiff and extreme cases of this stage.

mod discs;
pub mod matrices;
mod nodes;
mod self_hits;

use measure::Effort;
use measure::extremes::Case;

pub fn cases(effort: Effort) -> Vec<Case> {
    let transforms = [matrices::cases(), nodes::cases(effort)].concat();
    [discs::cases(effort), transforms, self_hits::cases(effort)].concat()
}
