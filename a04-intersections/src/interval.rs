//! `Interval`: the valid range of a ray's `t`.
//!
//! The interval goes INTO every search. If only the nearest hit were checked
//! afterwards, an invalid hit would hide the valid one behind it.

/// An open interval: its ends do not belong to it, and NaN belongs to no interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The lower end, which `t` must exceed.
    pub min: f64,
    /// The upper end, which `t` must stay below.
    pub max: f64,
}

impl Interval {
    /// The whole ray except its origin, where a ray that leaves a surface meets this
    /// surface at `t = 0`.
    pub const AHEAD: Self = Self {
        min: 0.0,
        max: f64::INFINITY,
    };

    /// The part of the ray before `max`.
    #[must_use]
    pub const fn before(max: f64) -> Self {
        Self { min: 0.0, max }
    }

    /// Whether `t` lies inside.
    #[must_use]
    // ANCHOR: contains
    pub fn contains(self, t: f64) -> bool {
        self.min < t && t < self.max
    }
    // ANCHOR_END: contains
}
