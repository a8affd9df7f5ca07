//! `AnyHitQuery`: a query for any hits of four rays that count.

use super::ids::ShapeId;
use super::query::Query;
use crate::lanes::{Lanes, RayPacket, is_set};
use crate::shape::{Counts, Primitive, Rays};

/// A query for any hits of four rays that count.
pub(crate) struct AnyHitQuery<'q> {
    rays: Rays,
    /// The `t` before which hits count.
    before: Lanes,
    counts: Counts<'q>,
    /// A bit for each ray that has no hit that counts yet.
    unfound: u32,
}

impl<'q> AnyHitQuery<'q> {
    /// A query for the active of four rays.
    pub fn new(packet: &RayPacket, before: Lanes, active: u32, counts: Counts<'q>) -> Self {
        Self {
            rays: Rays::four(packet, active),
            before,
            counts,
            unfound: active,
        }
    }

    /// A bit for each of these rays that has a hit that counts.
    pub fn found(&self, active: u32) -> u32 {
        active & !self.unfound
    }
}

impl Query for AnyHitQuery<'_> {
    type Shared = ();

    fn rays(&self) -> &Rays {
        &self.rays
    }

    fn active(&self) -> u32 {
        self.unfound
    }

    fn t_max(&self) -> &Lanes {
        &self.before
    }

    fn update<P: Primitive>(
        &mut self,
        t: Lanes,
        _: u32,
        _: ShapeId,
        primitive: impl FnOnce() -> P,
        (): &mut (),
    ) {
        let hit = t.simd_lt(self.before).to_bitmask() & self.unfound;
        if hit == 0 {
            return;
        }
        let primitive = primitive();
        let hits = primitive.hits(&self.rays, t, hit);
        let mut found = hit & (self.counts)(&hits);
        let others = hit & !found;
        if others != 0 {
            found |= primitive.any_hit_of_parts(&self.rays, self.before, others, self.counts);
        }
        self.unfound &= !found;
    }

    fn update_ray<P: Primitive>(
        &mut self,
        lane: usize,
        t: f64,
        order: u32,
        shape: ShapeId,
        primitive: impl FnOnce() -> P,
        (): &mut (),
    ) {
        if is_set(self.unfound, lane) {
            let mut of_lane = [f64::NAN; 4];
            of_lane[lane] = t;
            self.update(Lanes::new(of_lane), order, shape, primitive, &mut ());
        }
    }
}
