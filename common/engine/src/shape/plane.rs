//! `Plane`: for one ray and for four rays.

use glam::DVec3;

use crate::lanes::{Lanes, PacketHit, RayPacket, Vector3x4, ahead};
use crate::{Hit, Interval, Ray};

/// The plane through a point, perpendicular to a normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// A point of the plane.
    pub point: DVec3,
    /// The normal, of length 1.
    pub normal: DVec3,
}

impl Plane {
    pub(crate) fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let t = (self.point - ray.origin).dot(self.normal) / ray.direction.dot(self.normal);
        within.contains(t).then(|| Hit::new(t, self.normal))
    }

    /// Where each of four rays meets the plane.
    #[expect(
        clippy::inline_always,
        reason = "a call would take as long as the test"
    )]
    #[inline(always)]
    pub(crate) fn meet(&self, rays: &RayPacket) -> Lanes {
        let (a, n) = (Vector3x4::splat(self.point), Vector3x4::splat(self.normal));
        ahead((a - rays.origin).dot(n) / rays.direction.dot(n))
    }

    /// The hits at these `t`.
    #[inline]
    pub(crate) fn hits(&self, t: Lanes) -> PacketHit {
        PacketHit::with_normals(t, Vector3x4::splat(self.normal))
    }
}
