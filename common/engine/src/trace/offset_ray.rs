//! `offset_rays`: rays that leave a surface without hitting it again.
//!
//! (Pharr, Jakob and Humphreys, Physically Based Rendering, 4th edition, section 6.8,
//! with an error bound for each shape.)

use fearless_simd::prelude::*;

use crate::lanes::{PacketHit, RayPacket, Vector3x4};

/// The rays that leave four hits in directions of length 1: to a light, or reflected.
#[inline(always)]
pub(super) fn offset_rays<S: Simd>(
    rays: &RayPacket<S>,
    hit: &PacketHit<S>,
    direction: Vector3x4<S>,
) -> RayPacket<S> {
    let point = rays.at(hit.t);
    let error = hit.rounding_error(rays);
    let leads_below = hit.geometric_normal.dot(direction).simd_lt(0.0);
    let offset = leads_below.select(-error, error);
    RayPacket {
        origin: point + hit.geometric_normal * offset,
        direction,
    }
}
