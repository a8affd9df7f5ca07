//! `NearestQuery`: a query for the nearest hits of four rays, and `NearestHits`, its result.

use super::ids::{Kind, ShapeId};
use super::query::Query;
use super::shapes::{Shapes, with_list};
use crate::Hit;
use crate::lanes::{Lanes, PacketHit, RayPacket, bits, mask, select};
use crate::shape::{List, Primitive, Rays};

/// The nearest hits of four rays.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NearestHits {
    /// A bit for each ray that hits anything.
    pub hit_mask: u32,
    /// The hits.
    pub hit: PacketHit,
    /// The surfaces that are hit.
    pub surfaces: [u32; 4],
}

impl NearestHits {
    /// Whether all four surfaces are the same.
    #[inline]
    pub fn is_one_surface(&self) -> bool {
        let [a, b, c, d] = self.surfaces;
        a == b && a == c && a == d
    }
}

/// A query for the nearest hits of four rays.
pub(crate) struct NearestQuery {
    rays: Rays,
    /// The nearest hits so far.
    t: Lanes,
    /// The positions in the list of the scene of the shapes hit there; below 0 without a hit.
    orders: Lanes,
    /// The bits of their ids.
    shapes: Lanes,
}

impl NearestQuery {
    /// A query for the active of four rays.
    #[inline]
    pub fn new(packet: &RayPacket, active: u32) -> Self {
        Self {
            rays: Rays::four(packet, active),
            t: Lanes::splat(f64::INFINITY),
            orders: Lanes::splat(-1.0),
            shapes: Lanes::ZERO,
        }
    }

    /// The same query for hits that are not behind these `t`.
    pub fn not_behind(mut self, t: Lanes) -> Self {
        // Hits at `t` count, too. NaN, the distance of a light of a student's own, is no limit.
        let beyond = t.to_array().map(f64::next_up);
        let beyond = beyond.map(|t| if t.is_nan() { f64::INFINITY } else { t });
        self.t = Lanes::new(beyond);
        self
    }

    /// The `t` of the nearest hits; the limit without a hit.
    pub fn t(&self) -> Lanes {
        self.t
    }

    /// A bit for each ray that hits anything.
    #[inline]
    pub fn hit_mask(&self) -> u32 {
        self.orders.simd_ge(Lanes::ZERO).to_bitmask()
    }
}

/// Of several hits at the same `t`, the one of the first shape of the list counts.
impl Query for NearestQuery {
    type Shared = ();

    #[inline]
    fn rays(&self) -> &Rays {
        &self.rays
    }

    #[inline]
    fn active(&self) -> u32 {
        self.rays.active
    }

    #[inline]
    fn t_max(&self) -> &Lanes {
        &self.t
    }

    /// Without a branch for the nearest hit, because no processor can predict it.
    #[inline]
    fn update<P: Primitive>(
        &mut self,
        t: Lanes,
        order: u32,
        shape: ShapeId,
        _: impl FnOnce() -> P,
        (): &mut (),
    ) {
        if t.simd_le(self.t).to_bitmask() & self.rays.active == 0 {
            return;
        }
        let order = Lanes::splat(order.into());
        let is_first = t.simd_eq(self.t) & order.simd_lt(self.orders);
        let found = (t.simd_lt(self.t) | is_first) & mask(self.rays.active);
        self.t = select(found, t, self.t);
        self.orders = select(found, order, self.orders);
        self.shapes = select(found, Lanes::splat(shape.to_bits()), self.shapes);
    }

    #[inline]
    fn update_ray<P: Primitive>(
        &mut self,
        lane: usize,
        t: f64,
        order: u32,
        shape: ShapeId,
        _: impl FnOnce() -> P,
        (): &mut (),
    ) {
        let nearest = &mut self.t.as_mut_array()[lane];
        let first = &mut self.orders.as_mut_array()[lane];
        let order = order.into();
        if t < *nearest || t == *nearest && order < *first {
            (*nearest, *first) = (t, order);
            self.shapes.as_mut_array()[lane] = shape.to_bits();
        }
    }
}

impl Shapes<'_> {
    /// The hits of a query, shape by shape, with normals that are turned against the rays.
    #[inline]
    pub fn hits(&self, query: &NearestQuery) -> NearestHits {
        let hits = self.hits_outwards(query);
        NearestHits {
            hit: hits.hit.facing(&query.rays.packet),
            ..hits
        }
    }

    /// The hits of a query, with normals that point out of the shapes.
    #[inline]
    pub fn hits_outwards(&self, query: &NearestQuery) -> NearestHits {
        let hit_mask = query.hit_mask();
        let mut hit = PacketHit::new([Hit::NONE; 4]);
        let mut surfaces = [0; 4];
        let shapes = query.shapes.to_array();
        let mut left = hit_mask;
        while left != 0 {
            let lane = left.trailing_zeros() as usize % 4;
            let order = Lanes::splat(query.orders.to_array()[lane]);
            let same = query.orders.simd_eq(order).to_bitmask();
            let shape = ShapeId::from_bits(shapes[lane]);
            let (of_shape, surface) = with_list!(self, shape.kind, |list| {
                let index = shape.index as usize;
                let hits = list.shapes.get(index).hits(&query.rays, query.t, same);
                (hits, list.attributes[index].surface)
            });
            if hit_mask & !same == 0 {
                hit = of_shape;
                surfaces = [surface; 4];
                break;
            }
            hit = of_shape.or(mask(same), hit);
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
