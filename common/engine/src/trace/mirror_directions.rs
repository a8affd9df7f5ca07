//! `mirror_directions`: the directions in which surfaces mirror rays.
//!
//! (Keller et al., The Iray Light Transport Simulation and Rendering System, 2017: a shading
//! normal is bent where the reflected ray would go into the surface.)

use glam::DVec3;

use crate::Hit;
use crate::lanes::{Lanes, OFFSET, PacketHit, RayPacket, Vector3x4, bits};
use crate::vector::normalized;

/// The directions, of length 1, in which the surfaces at four hits mirror the rays.
#[inline]
pub(super) fn mirror_directions(rays: &RayPacket, hit: &PacketHit) -> Vector3x4 {
    let reflected = (-rays.direction).reflected_on(hit.normal);
    let into_surface = reflected.dot(hit.geometric_normal).simd_lt(Lanes::ZERO);
    let into_surface = into_surface.to_bitmask();
    if into_surface == 0 {
        return reflected;
    }
    let (rays, hits) = (rays.to_rays(), hit.to_hits());
    let mut directions = reflected.to_lanes();
    for lane in bits(into_surface) {
        directions[lane] = along_the_surface(-rays[lane].direction, &hits[lane]);
    }
    Vector3x4::new(directions)
}

/// The direction along the surface in the plane of the shading normal and of `e`, which points to
/// the eye.
#[cold]
fn along_the_surface(e: DVec3, hit: &Hit) -> DVec3 {
    let geometric = hit.geometric_normal;
    let k = e.dot(geometric) / hit.normal.dot(geometric);
    match normalized(hit.normal * k - e) {
        Some(along) => along + geometric * OFFSET,
        None => geometric * (2.0 * geometric.dot(e)) - e,
    }
}
