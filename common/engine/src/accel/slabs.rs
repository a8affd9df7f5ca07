//! `Slabs`: rays against eight boxes, one for each lane.
//!
//! The slabs of a box are entered at `(plane - origin) / direction`. (Kay and Kajiya, Ray
//! Tracing Complex Scenes, 1986.) Of several rays in a lane, interval arithmetic bounds all at
//! once: with the extreme origins and directions, no ray enters earlier or leaves later. (Boulos,
//! Wald and Shirley, Geometric and Arithmetic Culling Methods for Entire Ray Packets, 2006.)

use std::ops::{Add, Sub};

use glam::DVec3;
use wide::f32x8;

use super::tree_space::{SLACK, TreeSpace};
use crate::Ray;

/// Boxes that are tested at once: the children of a node.
pub(super) const WIDTH: usize = 8;

/// Rays, prepared for the slab test of eight boxes, with `N` extremes of their directions in
/// each lane.
#[derive(Debug)]
pub(super) struct Slabs<const N: usize> {
    pub axes: [Slab<N>; 3],
    /// The least `t` at which hits count.
    pub t_min: f32x8,
    /// The dominant axis, along which all rays go farthest. None if all hits lie within the
    /// bounds of their shapes.
    pub dominant_axis: Option<usize>,
}

/// One axis of rays for the slab test.
#[derive(Debug)]
pub(super) struct Slab<const N: usize> {
    /// Which plane of a slab all rays meet first.
    pub side: Side,
    near: f32x8,
    far: f32x8,
    inverses: [f32x8; N],
}

/// The plane of a slab that rays meet first.
///
/// Rays with the direction 0 are parallel to the slab, and either plane may count as the first.
/// The sign of a 0 is never looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// The lower plane: no direction is below 0.
    Lower,
    /// The upper plane: no direction is above 0.
    Upper,
}

impl Side {
    /// The side of rays whose least direction this is, if they do not go both ways.
    #[inline]
    pub fn of(least: f64) -> Self {
        if least < 0.0 {
            Self::Upper
        } else {
            Self::Lower
        }
    }
}

impl Slabs<1> {
    /// A ray. None if it starts too far away, if a coordinate is no number, or if its direction is
    /// far from length 1.
    #[inline]
    pub fn of_ray(space: &TreeSpace, ray: &Ray) -> Option<Self> {
        let d = ray.direction;
        let o = (ray.origin - space.centre) * space.scale;
        let largest = o.abs().max_element().max(1.0);
        let is_within = o.is_finite() && largest <= 1e30 && has_length_1(d);
        is_within.then(|| {
            let slack = slack(largest);
            let slab = |axis: usize| {
                let splat = |x: f64| f32x8::splat(x as f32);
                Slab::new(Side::of(d[axis]), [o[axis]; 2], [d[axis]], slack, splat)
            };
            Self {
                axes: [0, 1, 2].map(slab),
                t_min: f32x8::splat(space.t_min()),
                dominant_axis: (!space.is_exact).then(|| d.abs().max_position()),
            }
        })
    }
}

/// The width added to slabs, for rays with origins up to this coordinate.
#[inline]
pub(super) fn slack(largest: f64) -> f64 {
    2.0 * largest * SLACK
}

fn has_length_1(d: DVec3) -> bool {
    (0.5..2.0).contains(&d.length_squared())
}

impl<const N: usize> Slab<N> {
    /// From the side of all rays and the extremes of their origins and directions, in ascending
    /// order, which `rounded` turns into lanes.
    ///
    /// Which way the rays go is said by the side alone. Of the directions only the magnitudes
    /// count, because a 0 among them may have the sign of the other way, and so has its inverse.
    #[inline]
    pub fn new<T>(
        side: Side,
        [min, max]: [T; 2],
        directions: [T; N],
        slack: T,
        rounded: impl Fn(T) -> f32x8,
    ) -> Self
    where
        T: Copy + Add<Output = T> + Sub<Output = T>,
    {
        // Rays parallel to the slab get a huge finite inverse, which avoids 0 * infinity.
        let huge = f32x8::splat(1e30);
        let inverses = directions.map(|d| (f32x8::ONE / rounded(d).abs()).fast_min(huge));
        let (near, far, inverses) = match side {
            Side::Lower => (max + slack, min - slack, inverses),
            Side::Upper => (min - slack, max + slack, inverses.map(|inverse| -inverse)),
        };
        Self {
            side,
            near: rounded(near),
            far: rounded(far),
            inverses,
        }
    }

    /// The `t` at which the first ray enters eight slabs, and the last one leaves them.
    #[inline]
    fn intersect(&self, planes: &[f32x8; 2]) -> (f32x8, f32x8) {
        let [lower, upper] = planes;
        let (first_plane, last_plane) = match self.side {
            Side::Lower => (lower, upper),
            Side::Upper => (upper, lower),
        };
        let near = *first_plane - self.near;
        let far = *last_plane - self.far;
        let (mut first, mut last) = (near * self.inverses[0], far * self.inverses[0]);
        for inverse in &self.inverses[1..] {
            first = first.fast_min(near * *inverse);
            last = last.fast_max(far * *inverse);
        }
        (first, last)
    }
}

impl<const N: usize> Slabs<N> {
    /// The `t`, at least 0, before which no ray hits shapes in the boxes, and a bit for each box
    /// that a ray may meet before `t_max`.
    ///
    /// A ray in the plane of a triangle may hit it outside of its bounds, if it passes
    /// through them: rounding alone weighs the depths of the corners, which the formula
    /// measures along the dominant axis. So the hit lies between the bounds along this axis,
    /// whereas the other two only say whether the ray passes through them.
    #[inline]
    pub fn intersect(&self, [x, y, z]: &[[f32x8; 2]; 3], t_max: f32x8) -> ([f32; WIDTH], u32) {
        let [sx, sy, sz] = &self.axes;
        let (x, y, z) = (sx.intersect(x), sy.intersect(y), sz.intersect(z));
        let near = x.0.fast_max(y.0).fast_max(z.0);
        let far = x.1.fast_min(y.1).fast_min(z.1);
        let (first, last) = match self.dominant_axis {
            None => (near, far),
            Some(0) => x,
            Some(1) => y,
            Some(_) => z,
        };
        let is_within = first.simd_le(t_max) & last.simd_ge(self.t_min);
        (
            first.fast_max(f32x8::ZERO).to_array(),
            (near.simd_le(far) & is_within).to_bitmask(),
        )
    }
}

#[cfg(test)]
pub(super) mod tests;
