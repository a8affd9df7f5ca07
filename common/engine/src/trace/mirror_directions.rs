//! `mirror_directions`: the directions in which surfaces mirror rays.
//!
//! (Keller et al., The Iray Light Transport Simulation and Rendering System, 2017: a shading
//! normal is bent where the reflected ray would go into the surface.)

use fearless_simd::prelude::*;
use glam::DVec3;

use crate::Hit;
use crate::lanes::{OFFSET, PacketHit, RayPacket, Vector3x4, bits, bits_of};
use crate::vector::normalized;

/// The directions, of length 1, in which the surfaces at four hits mirror the rays.
#[inline(always)]
pub(super) fn mirror_directions<S: Simd>(rays: &RayPacket<S>, hit: &PacketHit<S>) -> Vector3x4<S> {
    let simd = rays.simd();
    let reflected = (-rays.direction).reflected_on(hit.normal);
    let into_surface = bits_of(reflected.dot(hit.geometric_normal).simd_lt(0.0));
    if into_surface == 0 {
        return reflected;
    }
    let (rays, hits) = (rays.to_rays(), hit.to_hits());
    let mut directions = reflected.to_lanes();
    for lane in bits(into_surface) {
        directions[lane] = along_the_surface(-rays[lane].direction, &hits[lane]);
    }
    Vector3x4::new(simd, directions)
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
