//! `offset_rays`: rays that leave a surface without hitting it again.
//!
//! (Pharr, Jakob and Humphreys, Physically Based Rendering, 4th edition, section 6.8,
//! with an error bound for each shape.)

use crate::lanes::{Lanes, PacketHit, RayPacket, Vector3x4};

/// The rays that leave four hits in directions of length 1: to a light, or reflected.
#[inline]
pub(super) fn offset_rays(rays: &RayPacket, hit: &PacketHit, direction: Vector3x4) -> RayPacket {
    let point = rays.at(hit.t);
    let side = hit.geometric_normal.dot(direction) & Lanes::splat(-0.0);
    let offset = hit.rounding_error(rays) | side;
    RayPacket {
        origin: point + hit.geometric_normal * offset,
        direction,
    }
}
