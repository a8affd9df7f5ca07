//! The stiff and extreme cases of this stage: transforms, nodes and discs.

mod discs;
pub mod matrices;
mod nodes;

use measure::Effort;
use measure::extremes::Case;

pub fn cases(effort: Effort) -> Vec<Case> {
    [
        discs::cases(effort),
        matrices::cases(),
        nodes::cases(effort),
    ]
    .concat()
}
