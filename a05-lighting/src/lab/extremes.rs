//! The stiff and extreme cases of this stage.

mod highlights;
mod lights;
mod materials;
mod spots;

use measure::Effort;
use measure::extremes::Case;

pub fn cases(effort: Effort) -> Vec<Case> {
    let others = [highlights::cases(), lights::cases(), materials::cases()];
    [spots::cases(effort), others.concat()].concat()
}
