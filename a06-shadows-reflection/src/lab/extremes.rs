//! The stiff and extreme cases of this stage.

mod mirrors;
pub mod self_hits;
mod shadows;
mod slopes;

use measure::Effort;
use measure::extremes::Case;

/// All rows of the table.
pub fn cases(effort: Effort) -> Vec<Case> {
    let mut cases = shadows::cases();
    cases.extend(slopes::cases(effort));
    cases.extend(mirrors::cases());
    cases.extend(self_hits::cases(effort));
    cases
}
