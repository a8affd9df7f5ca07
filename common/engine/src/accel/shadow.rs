//! The query for shapes between four points and a source of light.

use fearless_simd::prelude::*;

use super::Shapes;
use super::ids::ShapeId;
use super::query::Query;
use crate::lanes::{Lanes, PacketHit, RayPacket, bits_of, mask, splat};
use crate::shape::{Counts, Rays};

/// The last shape that blocked the light of a source. The next shadow rays are tested against it
/// first. (Haines and Greenberg, The Light Buffer, 1986: shadow caching.)
pub(crate) type Occluder = Option<ShapeId>;

/// Says which hits of a shadow ray block the light.
pub(super) struct Shadow<'q, S: Simd> {
    /// By as much the origins of the rays are offset.
    offset: Lanes<S>,
    /// Whether a ray that has hit anything looks for no more.
    ends_at_first: bool,
    /// Says which hits block the light, inside of an instance.
    counts: Option<Counts<'q, S>>,
}

impl<'q, S: Simd> Query<'q, S> {
    /// A query for any hits of the active of four shadow rays, whose origins are offset, before a light
    /// at this distance. It ends at the first hits or, to measure what that saves, never.
    #[inline(always)]
    pub fn shadow(
        packet: &RayPacket<S>,
        offset: Lanes<S>,
        distance: Lanes<S>,
        active: u32,
        ends_at_first: bool,
    ) -> Self {
        let shadow = Shadow {
            offset,
            ends_at_first,
            counts: None,
        };
        Self::before_a_light(packet, distance, active, shadow)
    }

    /// The query inside of an instance, in whose space these rays are; the query outside says which
    /// hits count.
    pub fn shadow_inside(
        packet: &RayPacket<S>,
        distance: Lanes<S>,
        active: u32,
        counts: Counts<'q, S>,
    ) -> Self {
        let shadow = Shadow {
            offset: splat(packet.simd(), 0.0),
            ends_at_first: true,
            counts: Some(counts),
        };
        Self::before_a_light(packet, distance, active, shadow)
    }

    #[inline(always)]
    fn before_a_light(
        packet: &RayPacket<S>,
        distance: Lanes<S>,
        active: u32,
        shadow: Shadow<'q, S>,
    ) -> Self {
        Self {
            t_max: distance,
            shadow: Some(shadow),
            ..Self::nearest(packet, active)
        }
    }

    /// Takes hits that block the light.
    #[inline(always)]
    pub(super) fn update_shadow(
        &mut self,
        t: Lanes<S>,
        order: u32,
        shape: ShapeId,
        shapes: &Shapes,
        occluder: &mut Occluder,
    ) {
        let hit = bits_of(t.simd_lt(self.t_max)) & self.active & !self.hit_mask();
        let Some(shadow) = &self.shadow else { return };
        if hit == 0 {
            return;
        }
        let blocked = shadow.blocked(&self.rays, t, self.t_max, hit, shape, shapes);
        if blocked != 0 {
            let is_blocked = mask(t.simd, blocked);
            self.orders = is_blocked.select(splat(t.simd, order.into()), self.orders);
            if shadow.ends_at_first {
                self.active &= !blocked;
                *occluder = Some(shape);
            }
        }
    }
}

impl<S: Simd> Shadow<'_, S> {
    /// A bit for each of these hits on a shape, before the light at this distance, that blocks it.
    #[inline(always)]
    fn blocked(
        &self,
        rays: &Rays<S>,
        t: Lanes<S>,
        distance: Lanes<S>,
        hit: u32,
        shape: ShapeId,
        shapes: &Shapes,
    ) -> u32 {
        let mut blocked = hit & self.blocked_far_from_the_light(t, distance);
        let in_question = hit & !blocked;
        if in_question != 0 {
            let hits = shapes.hits_on(shape, rays, t, in_question);
            blocked |= in_question & self.blocked_by(&hits, rays, distance);
            let held = hit & !blocked;
            if held != 0 {
                // Other parts of the shape may lie behind the one that holds the light.
                let counts = |hit: &PacketHit<S>| self.blocked_by(hit, rays, distance);
                blocked |= shapes.any_hit_of_parts(shape, rays, distance, held, &counts);
            }
        }
        blocked
    }

    /// A bit for each ray whose hit certainly blocks the light, because it is far from the light.
    #[inline(always)]
    fn blocked_far_from_the_light(&self, t: Lanes<S>, distance: Lanes<S>) -> u32 {
        match self.counts {
            Some(_) => 0,
            None => bits_of(t.simd_lt(distance * (15.0 / 16.0))),
        }
    }

    /// A bit for each of these hits before the light that blocks it. Surfaces do not that hold the
    /// light, up to the rounding errors at both ends of the ray.
    #[inline(always)]
    fn blocked_by(&self, hit: &PacketHit<S>, rays: &Rays<S>, distance: Lanes<S>) -> u32 {
        if let Some(counts) = self.counts {
            return counts(hit);
        }
        let cosine = rays.packet.direction.dot(hit.geometric_normal).abs();
        let beyond_the_surface = (distance - hit.t) * cosine;
        let rounding = self.offset + hit.rounding_error(&rays.packet);
        !bits_of(beyond_the_surface.simd_le(rounding))
    }
}
