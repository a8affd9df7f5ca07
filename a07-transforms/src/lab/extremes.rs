//! The stiff and extreme cases of this stage.

mod discs;
pub mod matrices;
mod nodes;

use measure::Effort;
use measure::extremes::Case;

pub fn cases(effort: Effort) -> Vec<Case> {
    let discs = discs::cases(effort);
    [discs, matrices::cases(), nodes::cases(effort)].concat()
}
