//! `Bounds`: the box along the axes that holds a shape.

use glam::DVec3;

/// The smallest box along the axes that holds a shape, or all of space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    /// The least coordinates.
    pub min: [f64; 3],
    /// The greatest coordinates.
    pub max: [f64; 3],
}

impl Bounds {
    /// All of space: for shapes without end, and for shapes the engine does not know.
    pub const EVERYWHERE: Self = Self {
        min: [f64::NEG_INFINITY; 3],
        max: [f64::INFINITY; 3],
    };

    /// The bounds of no shape.
    pub const EMPTY: Self = Self {
        min: [f64::INFINITY; 3],
        max: [f64::NEG_INFINITY; 3],
    };

    /// The bounds of some points.
    pub fn around(points: impl IntoIterator<Item = DVec3>) -> Self {
        let points = points.into_iter().map(|p| p.to_array());
        points.fold(Self::EMPTY, |all, p| all.union(Self { min: p, max: p }))
    }

    /// The bounds of a shape with these values of the support function for the axes, with the sign
    /// 1, and for their opposites, with the sign -1. Rounded outwards.
    pub fn from_support(support: impl Fn(usize, f64) -> f64) -> Self {
        Self {
            min: [0, 1, 2].map(|axis| (-support(axis, -1.0)).next_down()),
            max: [0, 1, 2].map(|axis| support(axis, 1.0).next_up()),
        }
    }

    /// The same bounds, moved outwards by this width on all sides.
    pub fn wider(self, width: f64) -> Self {
        Self {
            min: self.min.map(|x| x - width),
            max: self.max.map(|x| x + width),
        }
    }

    /// The bounds of both.
    pub fn union(self, other: Self) -> Self {
        Self {
            min: std::array::from_fn(|axis| self.min[axis].min(other.min[axis])),
            max: std::array::from_fn(|axis| self.max[axis].max(other.max[axis])),
        }
    }

    /// Whether all bounds are numbers.
    pub fn are_finite(self) -> bool {
        self.min.iter().chain(&self.max).all(|x| x.is_finite())
    }

    /// The largest magnitude of a coordinate along each axis.
    pub fn magnitudes(self) -> [f64; 3] {
        std::array::from_fn(|axis| self.min[axis].abs().max(self.max[axis].abs()))
    }

    /// The middle along each axis.
    pub fn middle(self) -> [f64; 3] {
        std::array::from_fn(|axis| self.min[axis].midpoint(self.max[axis]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOX: Bounds = Bounds {
        min: [1.0, -2.0, 3.0],
        max: [3.0, 3.0, 9.0],
    };

    #[test]
    fn a_box_has_a_middle_and_magnitudes() {
        assert_eq!(BOX.middle(), [2.0, 0.5, 6.0]);
        assert_eq!(BOX.magnitudes(), [3.0, 3.0, 9.0]);
    }

    #[test]
    fn bounds_are_finite_if_all_six_are() {
        assert!(BOX.are_finite());
        for axis in 0..3 {
            let mut endless = BOX;
            endless.min[axis] = f64::NEG_INFINITY;
            assert!(!endless.are_finite());
            let mut unknown = BOX;
            unknown.max[axis] = f64::NAN;
            assert!(!unknown.are_finite());
        }
    }

    #[test]
    fn unions_hold_both_and_wider_bounds_reach_farther_on_all_sides() {
        let other = Bounds::around([DVec3::new(2.0, 7.0, 3.5)]);
        let both = Bounds {
            max: [3.0, 7.0, 9.0],
            ..BOX
        };
        assert_eq!(BOX.union(other), both);
        assert_eq!(BOX.union(Bounds::EMPTY), BOX);
        let wider = Bounds {
            min: [0.5, -2.5, 2.5],
            max: [3.5, 3.5, 9.5],
        };
        assert_eq!(BOX.wider(0.5), wider);
    }

    #[test]
    fn bounds_from_the_support_function_are_rounded_outwards() {
        let bounds = Bounds::from_support(|axis, sign| {
            let side = if sign < 0.0 { BOX.min } else { BOX.max };
            side[axis] * sign
        });
        let wider = Bounds {
            min: BOX.min.map(f64::next_down),
            max: BOX.max.map(f64::next_up),
        };
        assert_eq!(bounds, wider);
    }
}
