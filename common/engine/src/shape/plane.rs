//! `Plane`.

use glam::DVec3;

use super::{Primitive, Rays};
use crate::lanes::{Lanes, PacketHit, Simd, Vector3x4, positive};

/// The plane through a point, perpendicular to a normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// A point of the plane.
    pub point: DVec3,
    /// The normal, of length 1.
    pub normal: DVec3,
}

/// Four planes.
pub(crate) struct Planes<S: Simd> {
    pub point: Vector3x4<S>,
    normal: Vector3x4<S>,
}

impl Primitive for &Plane {
    type Four<S: Simd> = Planes<S>;

    #[inline(always)]
    fn four<S: Simd>(simd: S, shapes: [Self; 4]) -> Planes<S> {
        Planes {
            point: Vector3x4::new(simd, shapes.map(|plane| plane.point)),
            normal: Vector3x4::new(simd, shapes.map(|plane| plane.normal)),
        }
    }

    #[inline(always)]
    fn intersect<S: Simd>(shapes: &Planes<S>, rays: &Rays<S>, _: u32) -> Lanes<S> {
        let (a, n) = (shapes.point, shapes.normal);
        let ray = &rays.packet;
        // The quotient of a ray within the plane is 0 / 0 = NaN: no hit.
        positive((a - ray.origin).dot(n) / ray.direction.dot(n))
    }

    #[inline(always)]
    fn hits<S: Simd>(self, rays: &Rays<S>, t: Lanes<S>, _: u32) -> PacketHit<S> {
        let to_point = Vector3x4::splat(t.simd, self.point) - rays.packet.origin;
        let normal = Vector3x4::splat(t.simd, self.normal);
        PacketHit::with_normals(t, normal, to_point.abs().dot(normal.abs()))
    }
}
