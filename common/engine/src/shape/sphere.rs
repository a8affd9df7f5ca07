//! `Sphere`.
//!
//! (Haines, Günther and Akenine-Möller, Precision Improvements for Ray/Sphere
//! Intersection, Ray Tracing Gems, 2019, chapter 7.)

use glam::DVec3;

use super::{Primitive, Rays};
use crate::lanes::{
    Lanes, NO_HIT, PacketHit, RayPacket, Vector3x4, copysign, first_positive,
    is_square_for_formulas, positive, select, without,
};
use crate::vector::normalized;

/// All points at one distance from a centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// The centre.
    pub center: DVec3,
    /// The radius.
    pub radius: f64,
}

/// A factor below 1. The rounding error of two squares, a few units in the last of
/// their 53 binary places, is smaller than the difference to 1.
const CLEARLY: f64 = 1.0 - 1e-12;

/// Four spheres.
pub(crate) struct Spheres {
    center: Vector3x4,
    radius: Lanes,
}

impl Primitive for &Sphere {
    type Four = Spheres;

    fn support(self, along: DVec3) -> f64 {
        self.center.dot(along) + self.radius * along.length()
    }

    #[inline]
    fn four(shapes: [Self; 4]) -> Spheres {
        Spheres {
            center: Vector3x4::new(shapes.map(|sphere| sphere.center)),
            radius: Lanes::new(shapes.map(|sphere| sphere.radius)),
        }
    }

    #[inline]
    fn intersect(shapes: &Spheres, rays: &Rays, _: u32) -> Lanes {
        let d = rays.packet.direction;
        let a = d.dot(d);
        if is_square_for_formulas(a).all() {
            return shapes.intersect(&rays.packet, a);
        }
        // As the lesson does: the same operations on numbers that are scaled by powers of two.
        let (packet, unit) = rays.packet.scaled();
        let a = packet.direction.dot(packet.direction);
        positive(shapes.intersect(&packet, a) / unit)
    }

    #[inline]
    fn hits(self, rays: &Rays, t: Lanes, _: u32) -> PacketHit {
        let f = rays.packet.origin - Vector3x4::splat(self.center);
        let outwards = f + rays.packet.direction * t;
        let (mut normal, is_unit) = outwards.normalized();
        if !(is_unit | t.is_nan()).all() {
            // A distant ray is rounded almost to the centre.
            let one = |v| normalized(v).unwrap_or(v);
            normal = Vector3x4::new(outwards.to_lanes().map(one));
        }
        PacketHit::with_normals(t, normal, Lanes::splat(self.radius))
    }
}

impl Spheres {
    /// Where rays, whose directions have these squared lengths, meet the spheres.
    #[inline]
    fn intersect(&self, rays: &RayPacket, a: Lanes) -> Lanes {
        let r = self.radius;
        let (f, d) = (rays.origin - self.center, rays.direction);
        let (f_d, f_f) = (f.dot(d), f.dot(f));
        let outside = f_f - r * r;

        // Most rays miss. Before the root and three quotients, rays are rejected that
        // pass beside the sphere, (f d)^2 < d^2 (f^2 - r^2), by more than rounding, and
        // rays that start outside and leave it behind.
        let clearly_outside = f_f * Lanes::splat(CLEARLY) - r * r;
        let beside = (f_d * f_d).simd_lt(a * clearly_outside);
        let leaving = f_d.simd_gt(Lanes::ZERO) & outside.simd_gt(Lanes::ZERO);
        if (beside | leaving).all() {
            return NO_HIT;
        }

        let middle = -f_d / a;
        let l = f + d * middle;
        let discriminant = r * r - l.dot(l);

        // A negative discriminant makes all that follows NaN.
        let t1 = middle + copysign((discriminant / a).sqrt(), middle);
        // Where a ray touches the sphere at its own origin, both roots are 0, which is no hit;
        // here t0 is 0 / 0 = NaN, which is none, either.
        let t0 = outside / (a * t1);
        let in_order = t0.simd_lt(t1);
        let (near, far) = (select(in_order, t0, t1), select(in_order, t1, t0));
        let t = first_positive(near, far);
        // Only a hit that is rounded to the centre has no normal.
        let outwards = f + d * t;
        let largest = outwards.largest_coordinate();
        without(!largest.simd_gt(Lanes::ZERO), t)
    }
}
