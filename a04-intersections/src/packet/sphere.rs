//! Four rays and a sphere.

use a02_math::vector3x4::{is_square_of_a_length, select};
use a02_math::{Lanes, Vector3x4};
use a03_rays_cameras::RayPacket;

use super::{NOWHERE, PacketHit, copysign, first_ahead, without};
use crate::Sphere;

/// Of two squares, rounding takes no larger share than what is missing here to 1: a few
/// units in the last of their 53 binary places.
const CLEARLY: f64 = 1.0 - 1e-12;

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
        let (a, f_d, f_f) = (d.dot(d), f.dot(d), f.dot(f));
        let outside = f_f - r * r;

        // To most rays the formula would say no. A root and three quotients sooner, that is
        // clear of all that pass beside the sphere, (f d)^2 < d^2 (f^2 - r^2), by more than
        // rounding, and of those that start outside and leave it behind.
        let clearly_outside = f_f * Lanes::splat(CLEARLY) - r * r;
        let beside = (f_d * f_d).simd_lt(a * clearly_outside);
        let leaving = f_d.simd_gt(Lanes::ZERO) & outside.simd_gt(Lanes::ZERO);
        if (beside | leaving).all() {
            return NOWHERE;
        }

        let middle = -f_d / a;
        let l = f + d * middle;
        let discriminant = r * r - l.dot(l);

        // Where the discriminant is negative, all that follows is NaN.
        let t1 = middle + copysign((discriminant / a).sqrt(), middle);
        let t0 = outside / (a * t1);
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
