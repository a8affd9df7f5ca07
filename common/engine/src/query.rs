//! Hits of rays without light: for one ray, and for four rays together.

use crate::accel::{NearestSearch, ShadowSearch};
use crate::lanes::{Lanes, RayPacket, is_set};
use crate::{Hit, Interval, Ray, Renderer};

impl Renderer<'_> {
    /// The nearest hit within the interval, its normals turned against the ray, and the
    /// index of the surface hit.
    #[must_use]
    pub fn hit(&self, ray: &Ray, within: Interval) -> Option<(Hit, u32)> {
        let (hit, surface) = self.tracer.accelerator.hit(ray, within)?;
        Some((hit.facing(ray.direction), surface))
    }

    /// Whether anything is hit within the interval.
    #[must_use]
    pub fn is_hit(&self, ray: &Ray, within: Interval) -> bool {
        self.tracer.accelerator.is_hit(ray, within)
    }

    /// Like `hit`, for those of four whole rays whose bits are set in `active`.
    #[must_use]
    pub fn hit_together(&self, rays: [&Ray; 4], active: u32) -> [Option<(Hit, u32)>; 4] {
        let packet = RayPacket::new(rays);
        let mut search = [NearestSearch::new(&packet, active)];
        self.tracer.accelerator.search(&mut search, &mut ());
        let hits = self.tracer.accelerator.hits(&search[0]);
        let of_lanes = hits.hit.to_hits();
        [0, 1, 2, 3]
            .map(|lane| is_set(hits.hit_mask, lane).then(|| (of_lanes[lane], hits.surfaces[lane])))
    }

    /// Like `is_hit`, for those of four rays whose bits are set in `active`, before
    /// `max`: a bit for each ray that hits anything.
    #[must_use]
    pub fn is_hit_together(&self, rays: [&Ray; 4], max: [f64; 4], active: u32) -> u32 {
        let (packet, max) = (RayPacket::new(rays), Lanes::new(max));
        let mut search = [ShadowSearch::new(&packet, max, active)];
        self.tracer.accelerator.search(&mut search, &mut None);
        active & !search[0].open
    }
}
