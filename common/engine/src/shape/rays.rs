//! `Rays`: rays about to be tested against shapes, in lanes: four rays for one shape, or
//! one ray four times for four shapes.

use std::cell::OnceCell;

use super::ShearedRays;
use crate::Ray;
use crate::lanes::{RayPacket, Vector3x4};

/// Rays about to be tested, and the numbers of them that are computed only once.
#[derive(Debug)]
pub(crate) struct Rays {
    /// The rays.
    pub packet: RayPacket,
    /// A bit for each ray that is tested.
    pub active: u32,
    sheared: OnceCell<ShearedRays>,
}

impl Rays {
    /// The active of four rays. An active one stands in for each of the others.
    #[inline]
    pub fn four(packet: &RayPacket, active: u32) -> Self {
        Self {
            packet: packet.filled(active),
            active,
            sheared: OnceCell::new(),
        }
    }

    /// One ray, four times.
    #[inline]
    pub fn one(ray: &Ray) -> Self {
        Self {
            packet: RayPacket {
                origin: Vector3x4::splat(ray.origin),
                direction: Vector3x4::splat(ray.direction),
            },
            active: 0b1111,
            sheared: OnceCell::new(),
        }
    }

    /// The same rays in another space.
    #[inline]
    pub fn with_packet(&self, packet: RayPacket) -> Self {
        Self {
            packet,
            active: self.active,
            sheared: OnceCell::new(),
        }
    }

    /// The rays as triangles need them.
    #[inline]
    pub fn sheared(&self) -> &ShearedRays {
        let sheared = || ShearedRays::new(&self.packet, self.active);
        self.sheared.get_or_init(sheared)
    }
}
