//! `RayPacket`: four rays side by side, so that one instruction serves all.
//!
//! Rays through neighbouring pixels meet much the same objects, so they can be
//! traced together (Wald, Slusallek, Benthin and Wagner, Interactive Rendering
//! with Coherent Ray Tracing, 2001).

use a02_math::{Lanes, Point3, Vector3, Vector3x4};

use crate::Ray;

/// Four rays.
#[derive(Clone, Copy, Debug)]
pub struct RayPacket {
    /// Where they start.
    pub origin: Vector3x4,
    /// Where they go.
    pub direction: Vector3x4,
}

impl RayPacket {
    /// These four rays.
    #[inline]
    #[must_use]
    pub fn new([a, b, c, d]: [&Ray; 4]) -> Self {
        let (o, to) = (
            |ray: &Ray| ray.origin().to_glam(),
            |ray: &Ray| ray.direction().to_glam(),
        );
        Self {
            origin: Vector3x4::new([o(a), o(b), o(c), o(d)]),
            direction: Vector3x4::new([to(a), to(b), to(c), to(d)]),
        }
    }

    /// The four rays, one by one.
    #[inline]
    #[must_use]
    pub fn to_rays(&self) -> [Ray; 4] {
        let (o, d) = (self.origin.to_lanes(), self.direction.to_lanes());
        let ray =
            |lane: usize| Ray::derived(Point3::from_glam(o[lane]), Vector3::from_glam(d[lane]));
        [ray(0), ray(1), ray(2), ray(3)]
    }

    /// The points `o + t d`.
    #[inline]
    #[must_use]
    pub fn at(&self, t: Lanes) -> Vector3x4 {
        self.origin + self.direction * t
    }
}
