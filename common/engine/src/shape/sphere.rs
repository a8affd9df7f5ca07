//! `Sphere`.
//!
//! (Haines, Günther and Akenine-Möller, Precision Improvements for Ray/Sphere
//! Intersection, Ray Tracing Gems, 2019, chapter 7.)

use fearless_simd::prelude::*;
use glam::DVec3;

use super::{Primitive, Rays};
use crate::lanes::{
    Lanes, PacketHit, RayPacket, Vector3x4, first_positive, is_square_for_formulas, lanes, no_hit,
    positive, splat, without,
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
pub(crate) struct Spheres<S: Simd> {
    center: Vector3x4<S>,
    radius: Lanes<S>,
}

impl Primitive for &Sphere {
    type Four<S: Simd> = Spheres<S>;

    fn support(self, along: DVec3) -> f64 {
        self.center.dot(along) + self.radius * along.length()
    }

    #[inline(always)]
    fn four<S: Simd>(simd: S, shapes: [Self; 4]) -> Spheres<S> {
        Spheres {
            center: Vector3x4::new(simd, shapes.map(|sphere| sphere.center)),
            radius: lanes(simd, shapes.map(|sphere| sphere.radius)),
        }
    }

    #[inline(always)]
    fn intersect<S: Simd>(shapes: &Spheres<S>, rays: &Rays<S>, _: u32) -> Lanes<S> {
        let d = rays.packet.direction;
        let a = d.dot(d);
        if is_square_for_formulas(a).all_true() {
            return shapes.intersect(&rays.packet, a);
        }
        // As the lesson does: the same operations on numbers that are scaled by powers of two.
        let (packet, unit) = rays.packet.scaled();
        let a = packet.direction.dot(packet.direction);
        positive(shapes.intersect(&packet, a) / unit)
    }

    #[inline(always)]
    fn hits<S: Simd>(self, rays: &Rays<S>, t: Lanes<S>, _: u32) -> PacketHit<S> {
        let simd = t.simd;
        let f = rays.packet.origin - Vector3x4::splat(simd, self.center);
        let outwards = f + rays.packet.direction * t;
        let (mut normal, is_unit) = outwards.normalized();
        if !(is_unit | t.is_nan()).all_true() {
            // A distant ray is rounded almost to the centre.
            let one = |v| normalized(v).unwrap_or(v);
            normal = Vector3x4::new(simd, outwards.to_lanes().map(one));
        }
        PacketHit::with_normals(t, normal, splat(simd, self.radius))
    }
}

impl<S: Simd> Spheres<S> {
    /// Where rays, whose directions have these squared lengths, meet the spheres.
    #[inline(always)]
    fn intersect(&self, rays: &RayPacket<S>, a: Lanes<S>) -> Lanes<S> {
        let r = self.radius;
        let (f, d) = (rays.origin - self.center, rays.direction);
        let (f_d, f_f) = (f.dot(d), f.dot(f));
        let outside = f_f - r * r;

        // Most rays miss. Before the root and three quotients, rays are rejected that
        // pass beside the sphere, (f d)^2 < d^2 (f^2 - r^2), by more than rounding, and
        // rays that start outside and leave it behind.
        let clearly_outside = f_f * CLEARLY - r * r;
        let beside = (f_d * f_d).simd_lt(a * clearly_outside);
        let leaving = f_d.simd_gt(0.0) & outside.simd_gt(0.0);
        if (beside | leaving).all_true() {
            return no_hit(r.simd);
        }

        let middle = -f_d / a;
        let l = f + d * middle;
        let discriminant = r * r - l.dot(l);

        // A negative discriminant makes all that follows NaN.
        let root = (discriminant / a).sqrt();
        let t1 = middle.simd_lt(0.0).select(middle - root, middle + root);
        // Where a ray touches the sphere at its own origin, both roots are 0, which is no hit;
        // here t0 is 0 / 0 = NaN, which is none, either.
        let t0 = outside / (a * t1);
        let in_order = t0.simd_lt(t1);
        let (near, far) = (in_order.select(t0, t1), in_order.select(t1, t0));
        let t = first_positive(near, far);
        // Only a hit that is rounded to the centre has no normal.
        let outwards = f + d * t;
        let largest = outwards.largest_coordinate();
        without(!largest.simd_gt(0.0), t)
    }
}
