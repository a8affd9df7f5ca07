//! `Interval`: which `t` of a ray count.
//!
//! The interval goes INTO every search. A check of the nearest hit afterwards
//! would let an invalid one hide the valid one behind it.

/// An open interval: its ends do not belong to it, and NaN belongs to none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The lower end, which `t` must exceed.
    pub min: f64,
    /// The upper end, which `t` must stay below.
    pub max: f64,
}

impl Interval {
    /// The whole ray but its origin, which belongs to the surface that it leaves.
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
