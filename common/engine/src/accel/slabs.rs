//! `Slabs`: rays against eight boxes, one for each lane.
//!
//! The slabs of a box are entered at `(plane - origin) / direction`. (Kay and Kajiya, Ray
//! Tracing Complex Scenes, 1986.) Of several rays in a lane, interval arithmetic bounds all at
//! once: with the extreme origins and directions, no ray enters earlier or leaves later. (Boulos,
//! Wald and Shirley, Geometric and Arithmetic Culling Methods for Entire Ray Packets, 2006.)

use fearless_simd::f32x8;
use fearless_simd::prelude::*;
use glam::DVec3;

use super::tree_space::{SLACK, TreeSpace};
use crate::Ray;

/// Boxes that are tested at once: the children of a node.
pub(super) const WIDTH: usize = 8;

/// Rays, prepared for the slab test of eight boxes, with `N` extremes of their directions in
/// each lane.
#[derive(Debug)]
pub(super) struct Slabs<S: Simd, const N: usize> {
    pub axes: [Slab<S, N>; 3],
    /// The least `t` at which hits count.
    pub t_min: f32x8<S>,
    /// The dominant axis, along which all rays go farthest. None if all hits lie within the
    /// bounds of their shapes.
    pub dominant_axis: Option<usize>,
}

/// One axis of rays for the slab test.
#[derive(Debug)]
pub(super) struct Slab<S: Simd, const N: usize> {
    /// Which plane of a slab all rays meet first.
    pub side: Side,
    near: f32x8<S>,
    far: f32x8<S>,
    inverses: [f32x8<S>; N],
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

impl<S: Simd> Slabs<S, 1> {
    /// A ray. None if it starts too far away, if a coordinate is no number, or if its direction is
    /// far from length 1.
    #[inline(always)]
    pub fn of_ray(simd: S, space: &TreeSpace, ray: &Ray) -> Option<Self> {
        let d = ray.direction;
        let o = (ray.origin - space.centre) * space.scale;
        let largest = o.abs().max_element().max(1.0);
        let is_within = o.is_finite() && largest <= 1e30 && has_length_1(d);
        if !is_within {
            return None;
        }
        let slack = slack(largest);
        Some(Self {
            axes: [
                Slab::splat(simd, [o.x; 2], [d.x], slack),
                Slab::splat(simd, [o.y; 2], [d.y], slack),
                Slab::splat(simd, [o.z; 2], [d.z], slack),
            ],
            t_min: space.t_min().simd_into(simd),
            dominant_axis: (!space.is_exact).then(|| d.abs().max_position()),
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

impl<S: Simd, const N: usize> Slab<S, N> {
    /// From the extremes of the origins, widened by the slack, and of the directions of rays that all
    /// go the same way, both in ascending order.
    ///
    /// Which way the rays go is said by the side alone. Of the directions only the magnitudes
    /// count, because a 0 among them may have the sign of the other way, and so has its inverse.
    #[inline(always)]
    pub fn new(side: Side, [min, max]: [f32x8<S>; 2], directions: [f32x8<S>; N]) -> Self {
        let mut inverses = directions;
        for inverse in &mut inverses {
            // Rays parallel to the slab get a huge finite inverse, which avoids 0 * infinity.
            *inverse = (1.0 / inverse.abs()).min(1e30);
            if side == Side::Upper {
                *inverse = -*inverse;
            }
        }
        let (near, far) = match side {
            Side::Lower => (max, min),
            Side::Upper => (min, max),
        };
        Self {
            side,
            near,
            far,
            inverses,
        }
    }

    /// The same, from numbers that all lanes share; `slack` widens the origins.
    #[inline(always)]
    pub fn splat(simd: S, [min, max]: [f64; 2], directions: [f64; N], slack: f64) -> Self {
        let mut singles = [f32x8::splat(simd, 0.0); N];
        for (single, direction) in singles.iter_mut().zip(directions) {
            *single = f32x8::splat(simd, direction as f32);
        }
        let min = f32x8::splat(simd, (min - slack) as f32);
        let max = f32x8::splat(simd, (max + slack) as f32);
        Self::new(Side::of(directions[0]), [min, max], singles)
    }

    /// The `t` at which the first ray enters eight slabs, and the last one leaves them.
    #[inline(always)]
    fn intersect(&self, planes: &[impl SimdInto<f32x8<S>, S> + Copy; 2]) -> (f32x8<S>, f32x8<S>) {
        let simd = self.near.simd;
        // An index needs no branch.
        let first = self.side as usize;
        let near = planes[first].simd_into(simd) - self.near;
        let far = planes[1 - first].simd_into(simd) - self.far;
        let (mut first, mut last) = (near * self.inverses[0], far * self.inverses[0]);
        for inverse in &self.inverses[1..] {
            first = first.min(near * *inverse);
            last = last.max(far * *inverse);
        }
        (first, last)
    }
}

impl<S: Simd, const N: usize> Slabs<S, N> {
    /// The `t`, at least 0, before which no ray hits shapes in the boxes, and a bit for each box
    /// that a ray may meet before `t_max`. All lanes have planes and a `t_max` of their own, or share one.
    ///
    /// A ray in the plane of a triangle may hit it outside of its bounds, if it passes
    /// through them: rounding alone weighs the depths of the corners, which the formula
    /// measures along the dominant axis. So the hit lies between the bounds along this axis,
    /// whereas the other two only say whether the ray passes through them.
    #[inline(always)]
    pub fn intersect(
        &self,
        [x, y, z]: &[[impl SimdInto<f32x8<S>, S> + Copy; 2]; 3],
        t_max: impl SimdInto<f32x8<S>, S>,
    ) -> ([f32; WIDTH], u32) {
        let [sx, sy, sz] = &self.axes;
        let (x, y, z) = (sx.intersect(x), sy.intersect(y), sz.intersect(z));
        let near = x.0.max(y.0).max(z.0);
        let far = x.1.min(y.1).min(z.1);
        let (first, last) = match self.dominant_axis {
            None => (near, far),
            Some(0) => x,
            Some(1) => y,
            Some(_) => z,
        };
        let is_within = first.simd_le(t_max) & last.simd_ge(self.t_min);
        (
            *first.max(0.0),
            (near.simd_le(far) & is_within).to_bitmask() as u32,
        )
    }
}

#[cfg(test)]
pub(super) mod tests;
