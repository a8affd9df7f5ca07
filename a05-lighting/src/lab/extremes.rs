//! The stiff and extreme cases of this stage.

mod lights;
mod materials;
mod spots;

use measure::Effort;
use measure::extremes::Case;

pub fn cases(effort: Effort) -> Vec<Case> {
    [spots::cases(effort), lights::cases(), materials::cases()].concat()
}
