//! `ShadowQuery`: a query for shapes between four points and a source of light.

use fearless_simd::prelude::*;

use super::Shapes;
use super::ids::ShapeId;
use super::query::Query;
use crate::lanes::{Lanes, PacketHit, RayPacket, bits_of, is_set, lanes, splat};
use crate::shape::{Counts, Rays};

/// The last shape that blocked the light of a source. The next shadow rays are tested against it
/// first. (Haines and Greenberg, The Light Buffer, 1986: shadow caching.)
pub(crate) type Occluder = Option<ShapeId>;

/// A query for any hits of four shadow rays.
pub(crate) struct ShadowQuery<'q, S: Simd> {
    rays: Rays<S>,
    /// The distances of the light, before which hits block it.
    distance: Lanes<S>,
    /// By as much the origins of the rays are offset.
    offset: Lanes<S>,
    /// A bit for each ray that has not hit anything yet.
    pub unoccluded: u32,
    /// Whether a ray that has hit anything looks for no more.
    ends_at_first: bool,
    /// Says which hits block the light, inside of an instance.
    counts: Option<Counts<'q, S>>,
}

impl<'q, S: Simd> ShadowQuery<'q, S> {
    /// A query for the active of four rays, whose origins are offset, to a light at this
    /// distance.
    #[inline(always)]
    pub fn new(packet: &RayPacket<S>, offset: Lanes<S>, distance: Lanes<S>, active: u32) -> Self {
        Self {
            rays: Rays::four(packet, active),
            distance,
            offset,
            unoccluded: active,
            ends_at_first: true,
            counts: None,
        }
    }

    /// The same query, which ends at the first hits or, to measure what that saves, never.
    #[inline(always)]
    pub fn ending_at_first(mut self, ends_at_first: bool) -> Self {
        self.ends_at_first = ends_at_first;
        self
    }

    /// The query inside of an instance, in whose space these rays are; the query outside says which
    /// hits count.
    pub fn inside(
        packet: &RayPacket<S>,
        distance: Lanes<S>,
        active: u32,
        counts: Counts<'q, S>,
    ) -> Self {
        let offset = splat(packet.simd(), 0.0);
        Self {
            counts: Some(counts),
            ..Self::new(packet, offset, distance, active)
        }
    }

    /// A bit for each ray whose hit certainly blocks the light, because it is far from the light.
    #[inline(always)]
    fn blocked_far_from_the_light(&self, t: Lanes<S>) -> u32 {
        match self.counts {
            Some(_) => 0,
            None => bits_of(t.simd_lt(self.distance * (15.0 / 16.0))),
        }
    }

    /// A bit for each of these hits before the light that blocks it. Surfaces do not that hold the
    /// light, up to the rounding errors at both ends of the ray.
    #[inline(always)]
    fn blocked_by(&self, hit: &PacketHit<S>) -> u32 {
        if let Some(counts) = self.counts {
            return counts(hit);
        }
        let rays = &self.rays.packet;
        let cosine = rays.direction.dot(hit.geometric_normal).abs();
        let beyond_the_surface = (self.distance - hit.t) * cosine;
        let rounding = self.offset + hit.rounding_error(rays);
        !bits_of(beyond_the_surface.simd_le(rounding))
    }
}

impl<S: Simd> Query<S> for ShadowQuery<'_, S> {
    type Shared = Occluder;

    #[inline(always)]
    fn rays(&self) -> &Rays<S> {
        &self.rays
    }

    #[inline(always)]
    fn active(&self) -> u32 {
        if self.ends_at_first {
            self.unoccluded
        } else {
            self.rays.active
        }
    }

    #[inline(always)]
    fn t_max(&self) -> &Lanes<S> {
        &self.distance
    }

    #[inline(always)]
    fn guess(occluder: &Occluder) -> Option<ShapeId> {
        *occluder
    }

    #[inline(always)]
    fn update(
        &mut self,
        t: Lanes<S>,
        _: u32,
        shape: ShapeId,
        shapes: &Shapes,
        occluder: &mut Occluder,
    ) {
        let hit = bits_of(t.simd_lt(self.distance)) & self.unoccluded;
        if hit == 0 {
            return;
        }
        let mut blocked = hit & self.blocked_far_from_the_light(t);
        let in_question = hit & !blocked;
        if in_question != 0 {
            let hits = shapes.hits_on(shape, &self.rays, t, in_question);
            blocked |= in_question & self.blocked_by(&hits);
            let held = hit & !blocked;
            if held != 0 {
                // Other parts of the shape may lie behind the one that holds the light.
                let counts = |hit: &PacketHit<S>| self.blocked_by(hit);
                blocked |= shapes.any_hit_of_parts(shape, &self.rays, self.distance, held, &counts);
            }
        }
        if blocked != 0 {
            self.unoccluded &= !blocked;
            *occluder = self.ends_at_first.then_some(shape);
        }
    }

    #[inline(always)]
    fn update_ray(
        &mut self,
        lane: usize,
        t: f64,
        order: u32,
        shape: ShapeId,
        shapes: &Shapes,
        occluder: &mut Occluder,
    ) {
        if is_set(self.unoccluded, lane) {
            let mut of_lane = [f64::NAN; 4];
            of_lane[lane] = t;
            let t = lanes(self.distance.simd, of_lane);
            self.update(t, order, shape, shapes, occluder);
        }
    }
}
