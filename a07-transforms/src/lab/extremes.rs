//! The stiff and extreme cases of this stage.

mod discs;
pub mod matrices;
mod nodes;
mod normals;
mod self_hits;

use measure::Effort;
use measure::extremes::Case;

pub fn cases(effort: Effort) -> Vec<Case> {
    let first = [discs::cases(effort), matrices::cases(), normals::cases()].concat();
    [first, nodes::cases(effort), self_hits::cases(effort)].concat()
}
