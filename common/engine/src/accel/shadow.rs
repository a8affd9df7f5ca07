//! `ShadowQuery`: a query for shapes between four points and a source of light.

use super::ids::ShapeId;
use super::query::Query;
use crate::lanes::{Lanes, PacketHit, RayPacket, is_set};
use crate::shape::{Primitive, Rays};

/// The last shape that blocked the light of a source. The next shadow rays are tested against it
/// first. (Haines and Greenberg, The Light Buffer, 1986: shadow caching.)
pub(crate) type Occluder = Option<ShapeId>;

/// A query for any hits of four shadow rays.
pub(crate) struct ShadowQuery {
    rays: Rays,
    /// The distances of the light.
    distance: Lanes,
    /// By as much the origins of the rays are offset.
    offset: Lanes,
    /// A bit for each ray that has not hit anything yet.
    pub unoccluded: u32,
    /// Whether a ray that has hit anything looks for no more.
    ends_at_first: bool,
}

impl ShadowQuery {
    /// A query for the active of four rays, whose origins are offset, to a light at this
    /// distance.
    #[inline]
    pub fn new(packet: &RayPacket, offset: Lanes, distance: Lanes, active: u32) -> Self {
        Self {
            rays: Rays::four(packet, active),
            distance,
            offset,
            unoccluded: active,
            ends_at_first: true,
        }
    }

    /// The same query, which ends at the first hits or, to measure what that saves, never.
    #[inline]
    pub fn ending_at_first(mut self, ends_at_first: bool) -> Self {
        self.ends_at_first = ends_at_first;
        self
    }

    /// A bit for each of these hits before the light that blocks it. Surfaces do not that hold the
    /// light, up to the rounding errors at both ends of the ray.
    #[inline]
    fn blocked_by(&self, hit: &PacketHit) -> u32 {
        let rays = &self.rays.packet;
        let cosine = rays.direction.dot(hit.geometric_normal).abs();
        let beyond_the_surface = (self.distance - hit.t) * cosine;
        let rounding = self.offset + hit.rounding_error(rays);
        !beyond_the_surface.simd_le(rounding).to_bitmask()
    }
}

impl Query for ShadowQuery {
    type Shared = Occluder;

    #[inline]
    fn rays(&self) -> &Rays {
        &self.rays
    }

    #[inline]
    fn active(&self) -> u32 {
        if self.ends_at_first {
            self.unoccluded
        } else {
            self.rays.active
        }
    }

    #[inline]
    fn t_max(&self) -> &Lanes {
        &self.distance
    }

    #[inline]
    fn guess(occluder: &Occluder) -> Option<ShapeId> {
        *occluder
    }

    #[inline]
    fn update<P: Primitive>(
        &mut self,
        t: Lanes,
        _: u32,
        shape: ShapeId,
        primitive: impl FnOnce() -> P,
        occluder: &mut Occluder,
    ) {
        let hit = t.simd_lt(self.distance).to_bitmask() & self.unoccluded;
        if hit == 0 {
            return;
        }
        let far_from_the_light = t.simd_lt(self.distance * Lanes::splat(15.0 / 16.0));
        let mut blocked = hit & far_from_the_light.to_bitmask();
        let near_the_light = hit & !blocked;
        if near_the_light != 0 {
            let primitive = primitive();
            let hits = primitive.hits(&self.rays, t, near_the_light);
            blocked |= near_the_light & self.blocked_by(&hits);
            let held = hit & !blocked;
            if held != 0 {
                // Other parts of the shape may lie behind the one that holds the light.
                let counts = |hit: &PacketHit| self.blocked_by(hit);
                blocked |= primitive.any_hit_of_parts(&self.rays, self.distance, held, &counts);
            }
        }
        if blocked != 0 {
            self.unoccluded &= !blocked;
            *occluder = self.ends_at_first.then_some(shape);
        }
    }

    #[inline]
    fn update_ray<P: Primitive>(
        &mut self,
        lane: usize,
        t: f64,
        order: u32,
        shape: ShapeId,
        primitive: impl FnOnce() -> P,
        occluder: &mut Occluder,
    ) {
        if is_set(self.unoccluded, lane) {
            let mut of_lane = [f64::NAN; 4];
            of_lane[lane] = t;
            self.update(Lanes::new(of_lane), order, shape, primitive, occluder);
        }
    }
}
