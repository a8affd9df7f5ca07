//! The query for the nearest hits of four rays, and `NearestHits`, its result.

use fearless_simd::prelude::*;

use super::ids::ShapeId;
use super::query::Query;
use super::shapes::Shapes;
use crate::Hit;
use crate::lanes::{Lanes, PacketHit, bits, bits_of, lanes, mask, splat};

/// The nearest hits of four rays.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NearestHits<S: Simd> {
    /// A bit for each ray that hits anything.
    pub hit_mask: u32,
    /// The hits.
    pub hit: PacketHit<S>,
    /// The surfaces that are hit.
    pub surfaces: [u32; 4],
}

impl<S: Simd> NearestHits<S> {
    /// Whether all four surfaces are the same.
    #[inline(always)]
    pub fn is_one_surface(&self) -> bool {
        let [a, b, c, d] = self.surfaces;
        a == b && a == c && a == d
    }
}

impl<S: Simd> Query<'_, S> {
    /// The same query for hits that are not behind these `t`.
    #[inline(always)]
    pub fn not_behind(mut self, t: Lanes<S>) -> Self {
        // Hits at `t` count, too. NaN, the distance of a light of a student's own, is no limit.
        let beyond = t.map(f64::next_up);
        let beyond = beyond.map(|t| if t.is_nan() { f64::INFINITY } else { t });
        self.t_max = lanes(t.simd, beyond);
        self
    }

    /// Takes hits that are nearer than those so far. Of several at the same `t`, the one of the first
    /// shape of the list counts. Without a branch for the nearest hit, because no processor can
    /// predict it.
    #[inline(always)]
    pub(super) fn update_nearest(&mut self, t: Lanes<S>, order: u32, shape: ShapeId) {
        if bits_of(t.simd_le(self.t_max)) & self.active == 0 {
            return;
        }
        let simd = t.simd;
        let order = splat(simd, order.into());
        let is_first = t.simd_eq(self.t_max) & order.simd_lt(self.orders);
        let found = (t.simd_lt(self.t_max) | is_first) & mask(simd, self.active);
        self.t_max = found.select(t, self.t_max);
        self.orders = found.select(order, self.orders);
        self.shapes = found.select(splat(simd, shape.to_bits()), self.shapes);
    }

    /// Takes a hit of one ray, at most at its `t_max`.
    #[inline(always)]
    pub(super) fn update_nearest_of_ray(
        &mut self,
        lane: usize,
        t: f64,
        order: u32,
        shape: ShapeId,
    ) {
        let nearest = &mut self.t_max[lane];
        let first = &mut self.orders[lane];
        let order = order.into();
        if t < *nearest || t == *nearest && order < *first {
            (*nearest, *first) = (t, order);
            self.shapes[lane] = shape.to_bits();
        }
    }
}

impl Shapes<'_> {
    /// The hits of a query, shape by shape, with normals that are turned against the rays.
    #[inline(always)]
    pub fn hits<S: Simd>(&self, query: &Query<S>) -> NearestHits<S> {
        let hits = self.hits_outwards(query);
        NearestHits {
            hit: hits.hit.facing(&query.rays.packet),
            ..hits
        }
    }

    /// The hits of a query, with normals that point out of the shapes.
    #[inline(always)]
    pub fn hits_outwards<S: Simd>(&self, query: &Query<S>) -> NearestHits<S> {
        let simd = query.simd();
        let hit_mask = query.hit_mask();
        let mut hit = PacketHit::new(simd, [Hit::NONE; 4]);
        let mut surfaces = [0; 4];
        let mut left = hit_mask;
        while left != 0 {
            let lane = left.trailing_zeros() as usize % 4;
            let same = bits_of(query.orders.simd_eq(query.orders[lane]));
            let shape = ShapeId::from_bits(query.shapes[lane]);
            let of_shape = self.hits_on(shape, &query.rays, query.t_max, same);
            let surface = self.attributes(shape).surface;
            if hit_mask & !same == 0 {
                hit = of_shape;
                surfaces = [surface; 4];
                break;
            }
            hit = of_shape.or(mask(simd, same), hit);
            for lane in bits(same) {
                surfaces[lane] = surface;
            }
            left &= !same;
        }
        NearestHits {
            hit_mask,
            hit,
            surfaces,
        }
    }
}
