//! `Disc`.

use glam::DVec3;

use super::plane::Planes;
use super::{Plane, Primitive, Rays};
use crate::lanes::{Lanes, PacketHit, without};

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

/// Four discs.
pub(crate) struct Discs {
    planes: Planes,
    radius: Lanes,
}

impl Primitive for &Disc {
    type Four = Discs;

    /// In radii, the disc reaches as far from its centre as the sine of the angle to the normal.
    fn support(self, along: DVec3) -> f64 {
        let sine = self.plane.normal.cross(along).length() + along.length() * ROUNDING;
        self.plane.point.dot(along) + self.radius * sine
    }

    #[inline]
    fn four(shapes: [Self; 4]) -> Discs {
        Discs {
            planes: <&Plane>::four(shapes.map(|disc| &disc.plane)),
            radius: Lanes::new(shapes.map(|disc| disc.radius)),
        }
    }

    #[inline]
    fn intersect(shapes: &Discs, rays: &Rays, active: u32) -> Lanes {
        let t = <&Plane>::intersect(&shapes.planes, rays, active);
        let from_center = rays.packet.at(t) - shapes.planes.point;
        let squared_radius = shapes.radius * shapes.radius;
        without(!from_center.dot(from_center).simd_le(squared_radius), t)
    }

    #[inline]
    fn hits(self, rays: &Rays, t: Lanes, active: u32) -> PacketHit {
        self.plane.hits(rays, t, active)
    }
}
