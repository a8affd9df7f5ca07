//! `Plane`.

use glam::DVec3;

use super::{Primitive, Rays};
use crate::lanes::{Lanes, PacketHit, Vector3x4, positive};

/// The plane through a point, perpendicular to a normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// A point of the plane.
    pub point: DVec3,
    /// The normal, of length 1.
    pub normal: DVec3,
}

/// Four planes.
pub(crate) struct Planes {
    pub point: Vector3x4,
    normal: Vector3x4,
}

impl Primitive for &Plane {
    type Four = Planes;

    #[inline]
    fn four(shapes: [Self; 4]) -> Planes {
        Planes {
            point: Vector3x4::new(shapes.map(|plane| plane.point)),
            normal: Vector3x4::new(shapes.map(|plane| plane.normal)),
        }
    }

    #[inline]
    fn intersect(shapes: &Planes, rays: &Rays, _: u32) -> Lanes {
        let (a, n) = (shapes.point, shapes.normal);
        let ray = &rays.packet;
        // The quotient of a ray within the plane is 0 / 0 = NaN: no hit.
        positive((a - ray.origin).dot(n) / ray.direction.dot(n))
    }

    #[inline]
    fn hits(self, rays: &Rays, t: Lanes, _: u32) -> PacketHit {
        let to_point = Vector3x4::splat(self.point) - rays.packet.origin;
        let normal = Vector3x4::splat(self.normal);
        PacketHit::with_normals(t, normal, to_point.abs().dot(normal.abs()))
    }
}
