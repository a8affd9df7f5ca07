//! `Slabs`: one ray, or a bundle of rays, against the bounds of eight children.
//!
//! The slabs of a box are entered at `(plane - origin) / direction`. (Kay and Kajiya, Ray
//! Tracing Complex Scenes, 1986.) Of a bundle, interval arithmetic bounds all rays at once:
//! with the extreme origins and directions, no ray enters earlier or leaves later. (Boulos,
//! Wald and Shirley, Geometric and Arithmetic Culling Methods for Entire Ray Packets, 2006.)

use glam::DVec3;
use wide::f32x8;

use super::bvh::WIDTH;
use super::units::{SLACK, Units};
use crate::Ray;
use crate::lanes::{Lanes, RayPacket, Vector3x4, mask};

impl Units {
    /// A ray whose hits count beyond `min`. None if it starts too far away, or if its
    /// direction is far from length 1.
    #[inline]
    pub fn ray(&self, ray: &Ray, min: f64) -> Option<Slabs<1>> {
        let d = ray.direction;
        let o = (ray.origin - self.centre) * self.per_length;
        let largest = o.abs().max_element().max(1.0);
        let is_within = largest <= 1e30 && has_length_1(d) && min >= 0.0;
        is_within.then(|| {
            let slack = 2.0 * largest * SLACK;
            Slabs {
                axes: [0, 1, 2].map(|axis| Slab::new([o[axis]], [d[axis]], slack)),
                from: f32x8::splat(self.from(min)),
                main: (!self.is_exact).then(|| d.abs().max_position()),
            }
        })
    }

    /// The active rays of some packets, if they are coherent: they go the same way along each
    /// axis, and up to the distance of 1 their places differ by less than `width`.
    #[inline]
    pub fn bundle<'r>(
        &self,
        packets: impl Iterator<Item = (&'r RayPacket, u32)>,
        width: f32,
    ) -> Option<Slabs<2>> {
        let mut origins = [
            Vector3x4::splat(DVec3::INFINITY),
            Vector3x4::splat(DVec3::NEG_INFINITY),
        ];
        let mut directions = origins;
        for (rays, active) in packets {
            let mask = mask(active);
            let add = |[least, greatest]: &mut [Vector3x4; 2], vectors: Vector3x4| {
                *least = least.least(vectors).or(mask, *least);
                *greatest = greatest.greatest(vectors).or(mask, *greatest);
            };
            add(&mut origins, rays.origin);
            add(&mut directions, rays.direction);
        }
        self.between(extremes(origins), extremes(directions), width)
    }

    /// Rays between these least and greatest origins and directions, if they are coherent.
    #[expect(
        clippy::inline_always,
        reason = "the result is half a kilobyte, which would be copied"
    )]
    #[inline(always)]
    fn between(&self, origins: [DVec3; 2], directions: [DVec3; 2], width: f32) -> Option<Slabs<2>> {
        let in_units = |o: DVec3| (o - self.centre) * self.per_length;
        let [o_min, o_max] = origins.map(in_units);
        let [d_min, d_max] = directions;
        let spread = (o_max - o_min) + (d_max - d_min);
        let goes_one_way = d_min.is_negative_bitmask() == d_max.is_negative_bitmask();
        let largest = o_min.abs().max(o_max.abs()).max_element().max(1.0);
        // None of them is far from length 1, if one is not and they differ little.
        let is_coherent = goes_one_way
            && spread.max_element() < f64::from(width).min(0.1)
            && largest <= 1e30
            && (0.75..1.5).contains(&d_min.length_squared());
        if !is_coherent {
            return None;
        }
        let main = if self.is_exact {
            None
        } else {
            Some(farthest(d_min.abs(), d_max.abs())?)
        };
        let slack = 2.0 * largest * SLACK;
        let slab = |axis| {
            let (origins, directions) = ([o_min, o_max], [d_min, d_max]);
            let along = |ends: [DVec3; 2]| ends.map(|end| end[axis]);
            Slab::new(along(origins), along(directions), slack)
        };
        Some(Slabs {
            axes: [slab(0), slab(1), slab(2)],
            from: f32x8::splat(self.from(0.0)),
            main,
        })
    }
}

/// The axis along which all vectors between two go farthest, if there is one.
#[inline]
fn farthest(a: DVec3, b: DVec3) -> Option<usize> {
    let (least, most) = (a.min(b), a.max(b));
    let axis = least.max_position();
    let is_farthest = |other| other == axis || most[other] < least[axis];
    (0..3).all(is_farthest).then_some(axis)
}

/// The least coordinates of the first four vectors, and the greatest of the others.
#[inline]
fn extremes([least, greatest]: [Vector3x4; 2]) -> [DVec3; 2] {
    let lanes = |Vector3x4 { x, y, z }: Vector3x4| Lanes::transpose([x, y, z, z]);
    let ([a, b, c, d], [e, f, g, h]) = (lanes(least), lanes(greatest));
    let least = a.fast_min(b).fast_min(c.fast_min(d));
    let greatest = e.fast_max(f).fast_max(g.fast_max(h));
    [least, greatest].map(|ends| {
        let [x, y, z, _] = ends.to_array();
        DVec3::new(x, y, z)
    })
}

fn has_length_1(d: DVec3) -> bool {
    (0.5..2.0).contains(&d.length_squared())
}

/// Rays, prepared for the slab test, with `N` extremes of their directions.
#[derive(Debug)]
pub(super) struct Slabs<const N: usize> {
    axes: [Slab<N>; 3],
    from: f32x8,
    /// The axis along which all rays go farthest, unless shapes are only hit within their
    /// bounds.
    main: Option<usize>,
}

/// One axis of rays for the slab test.
#[derive(Debug)]
struct Slab<const N: usize> {
    /// The index of the plane of the slab that the rays meet first.
    side: usize,
    near: f32x8,
    far: f32x8,
    inverses: [f32x8; N],
}

impl<const N: usize> Slab<N> {
    /// From the extremes of origins and directions, in ascending order.
    #[inline]
    fn new(origins: [f64; N], directions: [f64; N], slack: f64) -> Self {
        let (min, max) = (origins[0], origins[N - 1]);
        // The direction -0 counts as downwards, like all others with a negative inverse.
        let downwards = directions[0].is_sign_negative();
        let (near, far) = if downwards {
            (min - slack, max + slack)
        } else {
            (max + slack, min - slack)
        };
        Self {
            side: usize::from(downwards),
            near: f32x8::splat(near as f32),
            far: f32x8::splat(far as f32),
            // Rays parallel to the slab get a huge finite inverse, which avoids
            // 0 * infinity.
            inverses: directions.map(|d| f32x8::splat((1.0 / d as f32).clamp(-1e30, 1e30))),
        }
    }

    /// The `t` at which the first ray enters eight slabs, and the last one leaves them.
    #[inline]
    fn enter(&self, planes: &[f32x8; 2]) -> (f32x8, f32x8) {
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
    /// The `t`, at least 0, before which no ray hits the shapes of the children, and a bit for
    /// each child that a ray may meet.
    ///
    /// A ray in the plane of a triangle may hit it outside of its bounds, if it passes
    /// through them: rounding alone weighs the depths of the corners, which the formula
    /// measures along the axis on which the ray goes farthest. So the hit lies between the
    /// bounds along this axis, whereas the other two only say whether the ray passes through
    /// them.
    #[inline]
    pub fn enter(&self, [x, y, z]: &[[f32x8; 2]; 3], beyond: f32) -> ([f32; WIDTH], u32) {
        let [sx, sy, sz] = &self.axes;
        let (x, y, z) = (sx.enter(x), sy.enter(y), sz.enter(z));
        let near = x.0.fast_max(y.0).fast_max(z.0);
        let far = x.1.fast_min(y.1).fast_min(z.1);
        let (first, last) = match self.main {
            None => (near, far),
            Some(0) => x,
            Some(1) => y,
            Some(_) => z,
        };
        let is_within = first.simd_le(f32x8::splat(beyond)) & last.simd_ge(self.from);
        (
            first.fast_max(f32x8::ZERO).to_array(),
            (near.simd_le(far) & is_within).to_bitmask(),
        )
    }
}

#[cfg(test)]
mod tests;
