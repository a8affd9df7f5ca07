//! Four rays and a sphere.

use a02_math::vector3x4::{is_square_of_a_length, select};
use a02_math::{Lanes, Vector3x4};
use a03_rays_cameras::RayPacket;

use super::{NOWHERE, PacketHit, copysign, first_ahead, without};
use crate::Sphere;

impl Sphere {
    /// Where each ray meets the sphere.
    #[expect(
        clippy::inline_always,
        reason = "a call would take as long as the test"
    )]
    #[inline(always)]
    pub(crate) fn meet(&self, rays: &RayPacket) -> Lanes {
        let r = Lanes::splat(self.r);
        let (f, d) = (self.relative_to_centre(rays.origin), rays.direction);
        let a = d.dot(d);
        let middle = -f.dot(d) / a;

        let l = f + d * middle;
        let discriminant = r * r - l.dot(l);
        if discriminant.simd_lt(Lanes::ZERO).all() {
            return NOWHERE;
        }

        // Where the discriminant is negative, all that follows is NaN.
        let t1 = middle + copysign((discriminant / a).sqrt(), middle);
        let t0 = (f.dot(f) - r * r) / (a * t1);
        let in_order = t0.simd_lt(t1);
        let (near, far) = (select(in_order, t0, t1), select(in_order, t1, t0));
        let t = first_ahead(near, far);
        // Only the centre itself has no normal: a hit is a radius away from it, or by
        // rounding on it, and nothing in between is too short to be squared.
        let outwards = f + d * t;
        without(!is_square_of_a_length(outwards.dot(outwards)), t)
    }

    /// All that there is to hits at these `t`.
    #[inline]
    pub(crate) fn hits(&self, rays: &RayPacket, t: Lanes) -> PacketHit {
        let (normal, _) = (self.relative_to_centre(rays.origin) + rays.direction * t).normalized();
        PacketHit {
            t,
            normal,
            face: normal,
        }
    }

    #[inline]
    fn relative_to_centre(&self, points: Vector3x4) -> Vector3x4 {
        points - Vector3x4::splat(self.c.to_glam())
    }
}
