//! `Units`: those of a tree, and `TreeBounds`: single precision numbers in them, rounded
//! outwards.

use glam::DVec3;

use crate::shape::Bounds;

/// The units of a tree: it measures from its centre in units of half its extent, so that
/// every scene, tiny or huge, near or far, fills the range from -1 to 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Units {
    pub centre: DVec3,
    pub per_length: f64,
    /// How far away from its bounds a shape may be hit, as a length.
    depth_error: f64,
    /// Whether shapes are only hit within their bounds.
    pub is_exact: bool,
}

/// Bounds are widened by this share of the largest number, in the units of the tree, so
/// that they hold every hit that a shape computes. The single precision of the slab
/// test and of its ray moves a hit by less than a quarter of it, and the double
/// precision of the shapes by far less.
pub(super) const SLACK: f64 = 1.0 / 1_048_576.0;

/// Bounds in the units of a tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TreeBounds {
    pub min: [f32; 3],
    pub max: [f32; 3],
}

impl TreeBounds {
    pub const NOWHERE: Self = Self {
        min: [f32::INFINITY; 3],
        max: [f32::NEG_INFINITY; 3],
    };

    /// The bounds of both.
    #[inline]
    pub fn union(self, other: Self) -> Self {
        // Comparisons that are one instruction each: no bound is NaN.
        let least = |a: f32, b: f32| if a < b { a } else { b };
        let greatest = |a: f32, b: f32| if a > b { a } else { b };
        Self {
            min: std::array::from_fn(|axis| least(self.min[axis], other.min[axis])),
            max: std::array::from_fn(|axis| greatest(self.max[axis], other.max[axis])),
        }
    }

    /// Twice the middle along each axis.
    #[inline]
    pub fn doubled_middle(self) -> [f32; 3] {
        std::array::from_fn(|axis| self.min[axis] + self.max[axis])
    }

    /// Half the surface area of the box, in proportion to the number of rays that meet
    /// it. 0 for the empty box.
    pub fn half_area(self) -> f32 {
        let [x, y, z] = std::array::from_fn(|axis| (self.max[axis] - self.min[axis]).max(0.0));
        x * y + y * z + z * x
    }

    /// The mean width of the box.
    pub fn mean_width(self) -> f32 {
        (0..3)
            .map(|axis| self.max[axis] - self.min[axis])
            .sum::<f32>()
            / 3.0
    }
}

impl Units {
    /// The units of a tree with these bounds, whose shapes may be hit this far away from
    /// theirs, and along two axes anywhere unless they are exact.
    pub fn new(all: Bounds, depth_error: f64, is_exact: bool) -> Self {
        let extent = (0..3).map(|axis| all.max[axis] / 2.0 - all.min[axis] / 2.0);
        Self {
            centre: all.middle().into(),
            per_length: 1.0 / extent.fold(f64::MIN_POSITIVE, f64::max),
            depth_error,
            is_exact,
        }
    }

    /// The bounds of a shape that may be hit this far away from them, in these units, rounded
    /// outwards.
    pub fn bounds(&self, bounds: Bounds, depth_error: f64) -> TreeBounds {
        let bounds = bounds.wider((depth_error - self.depth_error).max(0.0));
        let own = |x: f64, axis: usize| ((x - self.centre[axis]) * self.per_length) as f32;
        TreeBounds {
            min: std::array::from_fn(|axis| own(bounds.min[axis], axis).next_down()),
            max: std::array::from_fn(|axis| own(bounds.max[axis], axis).next_up()),
        }
    }

    /// Where rays enter the last bounds that may hold hits before `t`, in these units.
    #[inline]
    pub fn beyond(&self, t: f64) -> f32 {
        ((t + self.depth_error) * self.per_length * (1.0 + SLACK)) as f32
    }

    /// Where rays leave the first bounds that may hold hits beyond `t`, in these units.
    #[inline]
    pub fn from(&self, t: f64) -> f32 {
        ((t * (1.0 - SLACK) - self.depth_error * (1.0 + SLACK)) * self.per_length) as f32
    }
}
