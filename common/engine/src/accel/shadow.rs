//! `ShadowQuery`: a query for shapes between four points and a source of light.

use super::ids::ShapeId;
use super::query::Query;
use crate::lanes::{Lanes, RayPacket, is_set};
use crate::shape::Rays;

/// The last shape that blocked the light of a source. The next shadow rays are tested against it
/// first. (Haines and Greenberg, The Light Buffer, 1986: shadow caching.)
pub(crate) type Occluder = Option<ShapeId>;

/// A query for any hits of four shadow rays.
pub(crate) struct ShadowQuery {
    rays: Rays,
    t_max: Lanes,
    /// A bit for each ray that has not hit anything yet.
    pub unoccluded: u32,
}

impl ShadowQuery {
    /// A query for hits of the active of four rays before `t_max`.
    #[inline]
    pub fn new(packet: &RayPacket, t_max: Lanes, active: u32) -> Self {
        Self {
            rays: Rays::four(packet, active),
            t_max,
            unoccluded: active,
        }
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
        self.unoccluded
    }

    #[inline]
    fn t_max(&self) -> &Lanes {
        &self.t_max
    }

    #[inline]
    fn guess(occluder: &Occluder) -> Option<ShapeId> {
        *occluder
    }

    #[inline]
    fn update(&mut self, t: Lanes, _: u32, shape: ShapeId, occluder: &mut Occluder) {
        let hit = t.simd_lt(self.t_max).to_bitmask() & self.unoccluded;
        if hit != 0 {
            self.unoccluded &= !hit;
            *occluder = Some(shape);
        }
    }

    #[inline]
    fn update_ray(&mut self, lane: usize, t: f64, _: u32, shape: ShapeId, occluder: &mut Occluder) {
        if is_set(self.unoccluded, lane) && t < self.t_max.as_array()[lane] {
            self.unoccluded &= !(1 << lane);
            *occluder = Some(shape);
        }
    }
}
