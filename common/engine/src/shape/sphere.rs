//! `Sphere`: for one ray, for four rays, and four spheres for one ray.
//!
//! (Haines, Günther and Akenine-Möller, Precision Improvements for Ray/Sphere
//! Intersection, Ray Tracing Gems, 2019, chapter 7.)

use glam::DVec3;

use crate::accel::WIDTH;
use crate::lanes::{
    Lanes, NOWHERE, PacketHit, RayPacket, Vector3x4, copysign, first_ahead, is_square_of_a_length,
    select, without,
};
use crate::shape::Bounds;
use crate::vector::normalized;
use crate::{Hit, Interval, Ray};

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

impl Sphere {
    pub(crate) fn bounds(&self) -> Bounds {
        Bounds::around([self.center]).wider(self.radius)
    }

    pub(crate) fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let (f, d) = (ray.origin - self.center, ray.direction);
        let a = d.dot(d);
        let middle = -f.dot(d) / a;
        let l = f + d * middle;
        let discriminant = self.radius * self.radius - l.dot(l);
        if discriminant < 0.0 {
            return None;
        }
        let t1 = middle + (discriminant / a).sqrt().copysign(middle);
        let t0 = (f.dot(f) - self.radius * self.radius) / (a * t1);
        let (near, far) = if t0 < t1 { (t0, t1) } else { (t1, t0) };
        let t = [near, far].into_iter().find(|t| within.contains(*t))?;
        Some(Hit::new(t, normalized(f + d * t)?))
    }

    /// Where each of four rays meets the sphere.
    #[expect(
        clippy::inline_always,
        reason = "a call would take as long as the test"
    )]
    #[inline(always)]
    pub(crate) fn meet(&self, rays: &RayPacket) -> Lanes {
        let r = Lanes::splat(self.radius);
        let (f, d) = (self.relative_to_center(rays.origin), rays.direction);
        let (a, f_d, f_f) = (d.dot(d), f.dot(d), f.dot(f));
        let outside = f_f - r * r;

        // Most rays miss. Before the root and three quotients, rays are rejected that
        // pass beside the sphere, (f d)^2 < d^2 (f^2 - r^2), by more than rounding, and
        // rays that start outside and leave it behind.
        let clearly_outside = f_f * Lanes::splat(CLEARLY) - r * r;
        let beside = (f_d * f_d).simd_lt(a * clearly_outside);
        let leaving = f_d.simd_gt(Lanes::ZERO) & outside.simd_gt(Lanes::ZERO);
        if (beside | leaving).all() {
            return NOWHERE;
        }

        let middle = -f_d / a;
        let l = f + d * middle;
        let discriminant = r * r - l.dot(l);

        // A negative discriminant makes all that follows NaN.
        let t1 = middle + copysign((discriminant / a).sqrt(), middle);
        let t0 = outside / (a * t1);
        let in_order = t0.simd_lt(t1);
        let (near, far) = (select(in_order, t0, t1), select(in_order, t1, t0));
        let t = first_ahead(near, far);
        // Only a hit on the centre itself has no normal. A hit is a radius away from the
        // centre, or by rounding on it, so no other vector is too short to be squared.
        let outwards = f + d * t;
        without(!is_square_of_a_length(outwards.dot(outwards)), t)
    }

    /// The hits at these `t`.
    #[inline]
    pub(crate) fn hits(&self, rays: &RayPacket, t: Lanes) -> PacketHit {
        let (normal, _) = (self.relative_to_center(rays.origin) + rays.direction * t).normalized();
        PacketHit::with_normals(t, normal)
    }

    #[inline]
    fn relative_to_center(&self, points: Vector3x4) -> Vector3x4 {
        points - Vector3x4::splat(self.center)
    }
}

/// Up to four spheres of a leaf, and their indices.
#[derive(Debug)]
pub(crate) struct SphereBlock {
    center: Vector3x4,
    radius: Lanes,
    /// The index of each sphere; `u32::MAX` in lanes without one.
    pub indices: [u32; WIDTH],
}

/// A ray, four times side by side.
pub(crate) struct SphereRay {
    origin: Vector3x4,
    direction: Vector3x4,
    a: Lanes,
}

impl SphereRay {
    #[inline]
    pub fn new(ray: &Ray) -> Self {
        Self {
            origin: Vector3x4::splat(ray.origin),
            direction: Vector3x4::splat(ray.direction),
            a: Lanes::splat(ray.direction.dot(ray.direction)),
        }
    }
}

impl SphereBlock {
    /// The spheres of these indices.
    pub fn new(indices: [u32; WIDTH], sphere: impl Fn(u32) -> Option<Sphere>) -> Self {
        // No ray has a discriminant with a missing sphere.
        let missing = Sphere {
            center: DVec3::NAN,
            radius: f64::NAN,
        };
        let spheres = indices.map(|index| sphere(index).unwrap_or(missing));
        Self {
            center: Vector3x4::new(spheres.map(|sphere| sphere.center)),
            radius: Lanes::new(spheres.map(|sphere| sphere.radius)),
            indices,
        }
    }

    /// A bit for each sphere whose discriminant is not negative: the operations of
    /// [`Sphere::hit`], in their order.
    #[inline]
    pub fn candidates(&self, ray: &SphereRay) -> u32 {
        let f = ray.origin - self.center;
        let middle = -f.dot(ray.direction) / ray.a;
        let l = f + ray.direction * middle;
        let discriminant = self.radius * self.radius - l.dot(l);
        discriminant.simd_ge(Lanes::ZERO).to_bitmask()
    }
}
