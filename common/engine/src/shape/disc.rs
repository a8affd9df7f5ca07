//! `Disc`: for one ray and for four rays.

use glam::DVec3;

use super::{Bounds, Plane};
use crate::lanes::{Lanes, PacketHit, RayPacket, Vector3x4, without};
use crate::{Hit, Interval, Ray};

/// The part of a plane around a point of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// The plane; its point is the centre.
    pub plane: Plane,
    /// The radius.
    pub radius: f64,
}

/// Upper bound of the rounding error of the rim, in radii.
const ROUNDING: f64 = 1.0 / 1_099_511_627_776.0;

impl Disc {
    /// Along an axis the disc reaches as far as the sine of the angle between axis
    /// and normal: the length of the normal's other two coordinates.
    pub(crate) fn bounds(&self) -> Bounds {
        let DVec3 { x, y, z } = self.plane.normal;
        let reach = [(y, z), (z, x), (x, y)].map(|(a, b)| self.radius * (a * a + b * b).sqrt());
        let (center, reach) = (self.plane.point, DVec3::from(reach));
        Bounds::around([center + reach, center - reach]).wider(self.radius * ROUNDING)
    }

    pub(crate) fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let hit = self.plane.hit(ray, within)?;
        let from_center = ray.at(hit.t) - self.plane.point;
        (from_center.dot(from_center) <= self.radius * self.radius).then_some(hit)
    }

    /// Where each of four rays meets the disc.
    #[inline]
    pub(crate) fn meet(&self, rays: &RayPacket) -> Lanes {
        let t = self.plane.meet(rays);
        let from_center = rays.at(t) - Vector3x4::splat(self.plane.point);
        let squared_radius = Lanes::splat(self.radius * self.radius);
        without(!from_center.dot(from_center).simd_le(squared_radius), t)
    }

    /// The hits at these `t`.
    #[inline]
    pub(crate) fn hits(&self, t: Lanes) -> PacketHit {
        self.plane.hits(t)
    }
}
