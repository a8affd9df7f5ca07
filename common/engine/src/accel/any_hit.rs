//! `AnyHitQuery`: a query for any hits of four rays that count.

use fearless_simd::prelude::*;

use super::ids::ShapeId;
use super::query::Query;
use crate::lanes::{Lanes, RayPacket, bits_of, is_set, lanes};
use crate::shape::{Counts, Primitive, Rays};

/// A query for any hits of four rays that count.
pub(crate) struct AnyHitQuery<'q, S: Simd> {
    rays: Rays<S>,
    /// The `t` before which hits count.
    before: Lanes<S>,
    counts: Counts<'q, S>,
    /// A bit for each ray that has no hit that counts yet.
    unfound: u32,
}

impl<'q, S: Simd> AnyHitQuery<'q, S> {
    /// A query for the active of four rays.
    pub fn new(
        packet: &RayPacket<S>,
        before: Lanes<S>,
        active: u32,
        counts: Counts<'q, S>,
    ) -> Self {
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

impl<S: Simd> Query<S> for AnyHitQuery<'_, S> {
    type Shared = ();

    fn rays(&self) -> &Rays<S> {
        &self.rays
    }

    fn active(&self) -> u32 {
        self.unfound
    }

    fn t_max(&self) -> &Lanes<S> {
        &self.before
    }

    fn update<P: Primitive>(
        &mut self,
        t: Lanes<S>,
        _: u32,
        _: ShapeId,
        primitive: impl FnOnce() -> P,
        (): &mut (),
    ) {
        let hit = bits_of(t.simd_lt(self.before)) & self.unfound;
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
            let t = lanes(self.before.simd, of_lane);
            self.update(t, order, shape, primitive, &mut ());
        }
    }
}
