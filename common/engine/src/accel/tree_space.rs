//! `TreeSpace`: the coordinates in which a tree measures, and `TreeBounds`: bounds in them, in
//! single precision, rounded outwards.

use glam::DVec3;

use crate::shape::Bounds;

/// The space of a tree: the origin is the centre of all shapes, and the unit half of their extent,
/// so that every scene, tiny or huge, near or far, fills the range from -1 to 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct TreeSpace {
    pub centre: DVec3,
    /// Factor from lengths of the scene to lengths in this space.
    pub scale: f64,
    /// Largest distance of a hit from the bounds of its shape, as a length of the scene.
    depth_error: f64,
    /// Whether all hits lie within the bounds of their shapes.
    pub is_exact: bool,
}

/// Bounds are widened by this factor of the largest coordinate, so that they hold every hit that
/// a shape computes. The single precision of the slab test and of its ray moves a hit by less than
/// a quarter of it, and the double precision of the shapes by far less.
pub(super) const SLACK: f64 = 1.0 / 1_048_576.0;

/// Bounds in the space of a tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TreeBounds {
    pub min: [f32; 3],
    pub max: [f32; 3],
}

impl TreeBounds {
    /// The bounds of no shape.
    pub const EMPTY: Self = Self {
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

    /// Twice the centroid.
    #[inline]
    pub fn doubled_centroid(self) -> [f32; 3] {
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

impl TreeSpace {
    /// The space of shapes with these bounds, whose hits may lie this far away from their own
    /// bounds along one axis, and anywhere along the other two unless they are exact.
    pub fn new(all: Bounds, depth_error: f64, is_exact: bool) -> Self {
        let extent = (0..3).map(|axis| all.max[axis] / 2.0 - all.min[axis] / 2.0);
        Self {
            centre: all.middle().into(),
            scale: 1.0 / extent.fold(f64::MIN_POSITIVE, f64::max),
            // Infinity, plus the infinite `t_max` of rays that are over, would be NaN.
            depth_error: depth_error.min(f64::MAX),
            is_exact,
        }
    }

    /// The bounds of a shape with this depth error in this space, rounded outwards.
    pub fn bounds(&self, bounds: Bounds, depth_error: f64) -> TreeBounds {
        let bounds = bounds.wider((depth_error - self.depth_error).max(0.0));
        let inside = |x: f64, axis: usize| ((x - self.centre[axis]) * self.scale) as f32;
        TreeBounds {
            min: std::array::from_fn(|axis| inside(bounds.min[axis], axis).next_down()),
            max: std::array::from_fn(|axis| inside(bounds.max[axis], axis).next_up()),
        }
    }

    /// The least `t`, in this space, at which rays leave bounds that may hold hits ahead.
    #[inline]
    pub fn t_min(&self) -> f32 {
        (-self.depth_error * (1.0 + SLACK) * self.scale) as f32
    }

    /// The greatest `t`, in this space, at which rays enter bounds that may hold hits before
    /// `t_max`.
    #[inline]
    pub fn t_max(&self, t_max: f64) -> f32 {
        ((t_max + self.depth_error) * self.scale * (1.0 + SLACK)) as f32
    }
}
