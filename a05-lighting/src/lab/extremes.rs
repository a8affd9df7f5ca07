//! The stiff and extreme cases of this stage.

mod lights;
mod materials;

use measure::Effort;
use measure::extremes::Case;

pub fn cases(effort: Effort) -> Vec<Case> {
    [lights::cases(effort), materials::cases()].concat()
}
