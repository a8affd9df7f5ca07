//! `NearestQuery`: a query for the nearest hits of four rays, and `NearestHits`, its result.

use fearless_simd::prelude::*;

use super::ids::ShapeId;
use super::query::Query;
use super::shapes::Shapes;
use crate::Hit;
use crate::lanes::{Lanes, PacketHit, RayPacket, bits, bits_of, lanes, mask, splat};
use crate::shape::Rays;

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

/// A query for the nearest hits of four rays.
pub(crate) struct NearestQuery<S: Simd> {
    rays: Rays<S>,
    /// The nearest hits so far.
    t: Lanes<S>,
    /// The positions in the list of the scene of the shapes hit there; below 0 without a hit.
    orders: Lanes<S>,
    /// The bits of their ids.
    shapes: Lanes<S>,
}

impl<S: Simd> NearestQuery<S> {
    /// A query for the active of four rays.
    #[inline(always)]
    pub fn new(packet: &RayPacket<S>, active: u32) -> Self {
        let simd = packet.simd();
        Self {
            rays: Rays::four(packet, active),
            t: splat(simd, f64::INFINITY),
            orders: splat(simd, -1.0),
            shapes: splat(simd, 0.0),
        }
    }

    /// The same query for hits that are not behind these `t`.
    #[inline(always)]
    pub fn not_behind(mut self, t: Lanes<S>) -> Self {
        // Hits at `t` count, too. NaN, the distance of a light of a student's own, is no limit.
        let beyond = t.map(f64::next_up);
        let beyond = beyond.map(|t| if t.is_nan() { f64::INFINITY } else { t });
        self.t = lanes(t.simd, beyond);
        self
    }

    /// The `t` of the nearest hits; the limit without a hit.
    #[inline(always)]
    pub fn t(&self) -> Lanes<S> {
        self.t
    }

    /// A bit for each ray that hits anything.
    #[inline(always)]
    pub fn hit_mask(&self) -> u32 {
        bits_of(self.orders.simd_ge(0.0))
    }
}

/// Of several hits at the same `t`, the one of the first shape of the list counts.
impl<S: Simd> Query<S> for NearestQuery<S> {
    type Shared = ();

    #[inline(always)]
    fn rays(&self) -> &Rays<S> {
        &self.rays
    }

    #[inline(always)]
    fn active(&self) -> u32 {
        self.rays.active
    }

    #[inline(always)]
    fn t_max(&self) -> &Lanes<S> {
        &self.t
    }

    /// Without a branch for the nearest hit, because no processor can predict it.
    #[inline(always)]
    fn update(&mut self, t: Lanes<S>, order: u32, shape: ShapeId, _: &Shapes, (): &mut ()) {
        if bits_of(t.simd_le(self.t)) & self.rays.active == 0 {
            return;
        }
        let simd = t.simd;
        let order = splat(simd, order.into());
        let is_first = t.simd_eq(self.t) & order.simd_lt(self.orders);
        let found = (t.simd_lt(self.t) | is_first) & mask(simd, self.rays.active);
        self.t = found.select(t, self.t);
        self.orders = found.select(order, self.orders);
        self.shapes = found.select(splat(simd, shape.to_bits()), self.shapes);
    }

    #[inline(always)]
    fn update_ray(
        &mut self,
        lane: usize,
        t: f64,
        order: u32,
        shape: ShapeId,
        _: &Shapes,
        (): &mut (),
    ) {
        let nearest = &mut self.t[lane];
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
    pub fn hits<S: Simd>(&self, query: &NearestQuery<S>) -> NearestHits<S> {
        let hits = self.hits_outwards(query);
        NearestHits {
            hit: hits.hit.facing(&query.rays.packet),
            ..hits
        }
    }

    /// The hits of a query, with normals that point out of the shapes.
    #[inline(always)]
    pub fn hits_outwards<S: Simd>(&self, query: &NearestQuery<S>) -> NearestHits<S> {
        let simd = query.t.simd;
        let hit_mask = query.hit_mask();
        let mut hit = PacketHit::new(simd, [Hit::NONE; 4]);
        let mut surfaces = [0; 4];
        let mut left = hit_mask;
        while left != 0 {
            let lane = left.trailing_zeros() as usize % 4;
            let same = bits_of(query.orders.simd_eq(query.orders[lane]));
            let shape = ShapeId::from_bits(query.shapes[lane]);
            let of_shape = self.hits_on(shape, &query.rays, query.t, same);
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
