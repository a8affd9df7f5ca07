//! The verdict about an answer, in two parts: its decision, and its value.

use crate::{Case, ExactAnswer};

/// The relative rounding error of doubles, `2^-53`.
pub const DOUBLE: f64 = 0.5 * f64::EPSILON;

/// How many rounding errors of its inputs an answer may be off. A formula of some dozen operations that
/// adds no error of its own kind stays below.
const ALLOWED: f64 = 16.0;

/// What is to be said of an answer. A part that no answer could fail is `None`, and is not counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Verdict {
    /// Whether it is a hit or a miss as it should be. `None` on a border, where the answer for numbers that
    /// differ by rounding is another one, and in the plane of a flat shape.
    pub decision: Option<bool>,
    /// Whether the `t` of a hit is a number and as near as the problem lets it be. `None` if there is none, or if
    /// any `t` up to twice the exact one would be.
    pub value: Option<bool>,
}

impl Verdict {
    /// Whether the answer could have been wrong.
    #[must_use]
    pub fn is_counted(self) -> bool {
        self.decision.is_some() || self.value.is_some()
    }

    /// Whether neither part is wrong.
    #[must_use]
    pub fn is_right(self) -> bool {
        self.decision != Some(false) && self.value != Some(false)
    }
}

/// The verdict about an answer for a case: the `t` that was found in doubles, if a hit was found.
#[must_use]
pub fn verdict(case: &Case, found: Option<f64>) -> Verdict {
    let is_hit = match case.answer {
        ExactAnswer::Hit(_) => Some(true),
        ExactAnswer::Miss => Some(false),
        // Neither a hit nor a miss contradicts infinitely many hits.
        ExactAnswer::Coplanar => None,
    };
    Verdict {
        decision: is_hit
            .filter(|_| !case.is_border)
            .map(|is_hit| is_hit == found.is_some()),
        value: found.and_then(|t| is_right_value(case, t)),
    }
}

/// Whether a `t` is right, if another one would not be.
fn is_right_value(case: &Case, t: f64) -> Option<bool> {
    if !t.is_finite() {
        return Some(false);
    }
    let (least, greatest) = match (&case.answer, case.between) {
        (ExactAnswer::Hit(hit), between) => {
            // One unit in the last place is at most two rounding errors.
            let allowed = ALLOWED * case.condition.max(1.0) * 2.0 * DOUBLE * hit.t.abs();
            let [least, greatest] = between.unwrap_or([hit.t, hit.t]);
            let (least, greatest) = (least.min(hit.t - allowed), greatest.max(hit.t + allowed));
            if least <= 0.0 && greatest >= 2.0 * hit.t {
                return None;
            }
            (least, greatest)
        }
        (_, Some([least, greatest])) => (least, greatest),
        (_, None) => return None,
    };
    Some(least <= t && t <= greatest)
}
