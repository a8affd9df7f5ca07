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
    /// The index of the plane of the slab that the rays meet first.
    side: usize,
    near: f32x8,
    far: f32x8,
    inverses: [f32x8; N],
}

impl Slabs<1> {
    /// A ray. None if it starts too far away, or if its direction is far from length 1.
    #[inline]
    pub fn of_ray(space: &TreeSpace, ray: &Ray) -> Option<Self> {
        let d = ray.direction;
        let o = (ray.origin - space.centre) * space.scale;
        let largest = o.abs().max_element().max(1.0);
        let is_within = largest <= 1e30 && has_length_1(d);
        is_within.then(|| {
            let slack = slack(largest);
            let slab = |axis: usize| {
                let splat = |x: f64| f32x8::splat(x as f32);
                Slab::new([o[axis]; 2], [d[axis]], slack, splat)
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
    /// From the extremes of origins and directions, in ascending order, which `rounded` turns into
    /// lanes.
    #[inline]
    pub fn new<T>(
        [min, max]: [T; 2],
        directions: [T; N],
        slack: T,
        rounded: impl Fn(T) -> f32x8,
    ) -> Self
    where
        T: Copy + Add<Output = T> + Sub<Output = T>,
    {
        let directions = directions.map(&rounded);
        // The direction -0 counts as downwards, like all others with a negative inverse.
        let is_downwards = directions[0].as_array()[0].is_sign_negative();
        let (near, far) = if is_downwards {
            (min - slack, max + slack)
        } else {
            (max + slack, min - slack)
        };
        let [most, least] = [1e30, -1e30].map(f32x8::splat);
        Self {
            side: usize::from(is_downwards),
            near: rounded(near),
            far: rounded(far),
            // Rays parallel to the slab get a huge finite inverse, which avoids
            // 0 * infinity.
            inverses: directions.map(|d| (f32x8::ONE / d).fast_min(most).fast_max(least)),
        }
    }

    /// The `t` at which the first ray enters eight slabs, and the last one leaves them.
    #[inline]
    fn intersect(&self, planes: &[f32x8; 2]) -> (f32x8, f32x8) {
        let near = planes[self.side] - self.near;
        let far = planes[self.side ^ 1] - self.far;
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
