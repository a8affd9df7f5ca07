//! The stiff and extreme cases of this stage: far lights, lights inside of objects, lights
//! without a position; points at the edge of a cone, on its axis, and behind the light;
//! colours by the protocol's printed formulas; powers for exponents from 0 to overflow.

mod lights;
mod materials;
mod spots;

use measure::Effort;
use measure::extremes::Case;

pub fn cases(effort: Effort) -> Vec<Case> {
    [spots::cases(effort), lights::cases(), materials::cases()].concat()
}
