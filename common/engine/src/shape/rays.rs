//! `Rays`: rays about to be tested against shapes, in lanes: four rays for one shape, or
//! one ray four times for four shapes.

use std::cell::OnceCell;

use super::ShearedRays;
use crate::Ray;
use crate::lanes::{RayPacket, Simd, Vector3x4};

/// Rays about to be tested, and the numbers of them that are computed only once.
#[derive(Debug)]
pub(crate) struct Rays<S: Simd> {
    /// The rays.
    pub packet: RayPacket<S>,
    /// A bit for each ray that is tested.
    pub active: u32,
    sheared: OnceCell<ShearedRays<S>>,
}

impl<S: Simd> Rays<S> {
    /// The active of four rays. An active one stands in for each of the others.
    #[inline(always)]
    pub fn four(packet: &RayPacket<S>, active: u32) -> Self {
        Self {
            packet: packet.filled(active),
            active,
            sheared: OnceCell::new(),
        }
    }

    /// One ray, four times.
    #[inline(always)]
    pub fn one(simd: S, ray: &Ray) -> Self {
        Self {
            packet: RayPacket {
                origin: Vector3x4::splat(simd, ray.origin),
                direction: Vector3x4::splat(simd, ray.direction),
            },
            active: 0b1111,
            sheared: OnceCell::new(),
        }
    }

    /// The same rays in another space.
    #[inline(always)]
    pub fn with_packet(&self, packet: RayPacket<S>) -> Self {
        Self {
            packet,
            active: self.active,
            sheared: OnceCell::new(),
        }
    }

    /// The rays as triangles need them.
    #[inline(always)]
    pub fn sheared(&self) -> &ShearedRays<S> {
        self.sheared.get_or_init(|| {
            self.packet.simd().vectorize(
                #[inline(always)]
                || ShearedRays::new(&self.packet, self.active),
            )
        })
    }
}
