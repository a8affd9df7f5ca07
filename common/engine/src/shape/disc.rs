//! `Disc`.

use fearless_simd::prelude::*;
use glam::DVec3;

use super::plane::Planes;
use super::{Plane, Primitive, Rays};
use crate::lanes::{Lanes, PacketHit, lanes, without};

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
pub(crate) struct Discs<S: Simd> {
    planes: Planes<S>,
    radius: Lanes<S>,
}

impl Primitive for &Disc {
    type Four<S: Simd> = Discs<S>;

    /// In radii, the disc reaches as far from its centre as the sine of the angle to the normal.
    fn support(self, along: DVec3) -> f64 {
        let sine = self.plane.normal.cross(along).length() + along.length() * ROUNDING;
        self.plane.point.dot(along) + self.radius * sine
    }

    #[inline(always)]
    fn four<S: Simd>(simd: S, shapes: [Self; 4]) -> Discs<S> {
        Discs {
            planes: <&Plane>::four(simd, shapes.map(|disc| &disc.plane)),
            radius: lanes(simd, shapes.map(|disc| disc.radius)),
        }
    }

    #[inline(always)]
    fn intersect<S: Simd>(shapes: &Discs<S>, rays: &Rays<S>, active: u32) -> Lanes<S> {
        let t = <&Plane>::intersect(&shapes.planes, rays, active);
        let from_center = rays.packet.at(t) - shapes.planes.point;
        let squared_radius = shapes.radius * shapes.radius;
        without(!from_center.dot(from_center).simd_le(squared_radius), t)
    }

    #[inline(always)]
    fn hits<S: Simd>(self, rays: &Rays<S>, t: Lanes<S>, active: u32) -> PacketHit<S> {
        self.plane.hits(rays, t, active)
    }
}
