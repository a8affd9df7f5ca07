//! Four rays and a plane.

use a02_math::{Lanes, Vector3x4};
use a03_rays_cameras::RayPacket;

use super::{PacketHit, ahead};
use crate::Plane;

impl Plane {
    /// Where each ray meets the plane.
    #[expect(
        clippy::inline_always,
        reason = "a call would take as long as the test"
    )]
    #[inline(always)]
    pub(crate) fn meet(&self, rays: &RayPacket) -> Lanes {
        let (a, n) = (self.a.to_glam(), self.n.to_glam());
        let (a, n) = (Vector3x4::splat(a), Vector3x4::splat(n));
        ahead((a - rays.origin).dot(n) / rays.direction.dot(n))
    }

    /// All that there is to hits at these `t`.
    #[inline]
    pub(crate) fn hits(&self, t: Lanes) -> PacketHit {
        let n = Vector3x4::splat(self.n.to_glam());
        PacketHit {
            t,
            normal: n,
            face: n,
        }
    }
}
