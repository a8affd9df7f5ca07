//! `ShadowSearch`: a search for shapes between four points and a source of light.

use std::slice;

use super::Accelerator;
use super::bvh::Leaf;
use super::search::{Search, largest};
use super::shapes::ShapeId;
use crate::Interval;
use crate::lanes::{Lanes, RayPacket, bits};
use crate::shape::Rays;

/// A shape that has kept away the light of a source, which the next rays to it may meet
/// first. (Haines and Greenberg, The Light Buffer, 1986: shadow caching.)
pub(crate) type Occluder = Option<ShapeId>;

/// A search for shapes that keep away the light of a source from four points.
pub(crate) struct ShadowSearch {
    rays: Rays,
    /// Only hits before count.
    max: Lanes,
    /// A bit for each ray that has not hit anything yet.
    pub open: u32,
    /// The last occluder that these rays were tested against.
    tested: Occluder,
}

impl ShadowSearch {
    /// A search for the active of four rays, before `max`.
    #[inline]
    pub fn new(packet: &RayPacket, max: Lanes, active: u32) -> Self {
        Self {
            rays: Rays::four(packet, active),
            max,
            open: active,
            tested: None,
        }
    }
}

impl Search for ShadowSearch {
    type Shared = Occluder;

    #[inline]
    fn rays(&self) -> &Rays {
        &self.rays
    }

    #[inline]
    fn open(&self) -> u32 {
        self.open
    }

    #[inline]
    fn beyond(&self) -> f64 {
        largest(self.max, self.open)
    }

    #[inline]
    fn take(&mut self, t: Lanes, _: u32, shape: ShapeId, occluder: &mut Occluder) {
        let hit = t.simd_lt(self.max).to_bitmask() & self.open;
        if hit != 0 {
            self.open &= !hit;
            *occluder = Some(shape);
        }
    }

    #[inline]
    fn guess(&mut self, accelerator: &Accelerator, occluder: &mut Occluder) {
        if *occluder != self.tested
            && let Some(shape) = *occluder
        {
            self.tested = *occluder;
            accelerator.test_all(&[Leaf::of(shape)], slice::from_mut(self), occluder);
        }
    }

    fn search_one_by_one(&mut self, accelerator: &Accelerator, occluder: &mut Occluder) {
        let (rays, max) = (self.rays.packet.to_rays(), self.max.to_array());
        for lane in bits(self.open) {
            let ray = &rays[lane];
            let within = Interval::before(max[lane]);
            let found = accelerator.search_any(ray, &Rays::one(ray, 0.0), within);
            if found.is_some() {
                self.open &= !(1 << lane);
                *occluder = found;
            }
        }
    }
}
