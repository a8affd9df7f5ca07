//! `Bracket`: two values of a number between which a margin changes its sign.

use super::{Margin, State};

/// A decision that changes between two displacements.
pub(super) struct Bracket {
    pub decision: u64,
    pub bends: bool,
    /// The displacements, the nearer one first, and the margins there.
    pub ends: [(f64, f64); 2],
}

impl Bracket {
    pub(super) fn new(margin: &Margin, ends: [(f64, f64); 2]) -> Self {
        Self {
            decision: margin.decision,
            bends: margin.bends,
            ends,
        }
    }

    /// The least distance at which the margin may change its sign: a quarter of the bracket before
    /// the root of the line through its ends.
    pub(super) fn nearest(&self) -> f64 {
        let [near, far] = self.ends;
        let fraction = near.1 / (near.1 - far.1);
        let fraction = if fraction.is_finite() { fraction } else { 0.0 };
        (near.0 + (fraction - 0.25).max(0.0) * (far.0 - near.0)).abs()
    }
}

/// The margin of a decision in a state, if it is taken there.
pub(super) fn margin_of(state: &State, decision: u64) -> Option<f64> {
    let margins = &state.margins;
    let found = margins.binary_search_by_key(&decision, |margin| margin.decision);
    found.ok().map(|index| margins[index].value)
}

/// Whether two margins decide differently; 0 decides as numbers above it do.
pub(super) fn differ(a: f64, b: f64) -> bool {
    (a >= 0.0) != (b >= 0.0)
}

/// The vertex of the parabola through three points.
pub(super) fn vertex([(x0, y0), (x1, y1), (x2, y2)]: [(f64, f64); 3]) -> Option<(f64, f64)> {
    let slope = (y1 - y0) / (x1 - x0);
    let curvature = ((y2 - y0) / (x2 - x0) - slope) / (x2 - x1);
    let x = f64::midpoint(x0, x1) - slope / (2.0 * curvature);
    let y = y0 + (x - x0) * (slope + (x - x1) * curvature);
    (x.is_finite() && y.is_finite()).then_some((x, y))
}
