//! `Primitive`: a shape with its formulas, alone and in lanes.
//!
//! In lanes a formula stands once: four rays meet one shape, which is then there four times,
//! and one ray, four times, meets four shapes.

use glam::DVec3;

use super::{Bounds, Rays};
use crate::lanes::{Lanes, PacketHit, is_set};
use crate::{Hit, Interval, Ray};

/// A shape that rays are tested against.
pub(crate) trait Primitive: Copy {
    /// Four shapes side by side.
    type Four;

    /// How far the shape reaches along a vector: the greatest dot product with one of its
    /// points.
    fn reach(self, _: DVec3) -> f64 {
        f64::INFINITY
    }

    /// How far away from the place where a ray passes through the bounds a hit may be, in
    /// lengths of the direction.
    fn depth_error(self) -> f64 {
        0.0
    }

    /// Bounds that hold every hit, or all of space.
    fn bounds(self) -> Bounds {
        Bounds::reached(|axis, sign| self.reach(DVec3::AXES[axis] * sign))
    }

    /// The nearest hit of a ray within an interval.
    fn hit(self, ray: &Ray, within: Interval) -> Option<Hit>;

    /// Four shapes side by side.
    fn four(shapes: [Self; 4]) -> Self::Four;

    /// The least `t` beyond the rays' `min` at which the ray of each lane meets the shape of
    /// the lane, with the bits of `hit`; NaN without a hit. Lanes whose bits are not set in
    /// `wanted` hold anything.
    fn meet(shapes: &Self::Four, rays: &Rays, wanted: u32) -> Lanes;

    /// The hits of four rays at these `t`, which `meet` has found for the wanted lanes.
    fn hits(self, rays: &Rays, t: Lanes, wanted: u32) -> PacketHit;
}

/// The hits of each wanted lane, for shapes that have no formula in lanes.
#[inline(never)]
pub(crate) fn one_by_one<P: Primitive>(shape: P, rays: &Rays, wanted: u32) -> PacketHit {
    let (alone, min) = (rays.packet.to_rays(), rays.min.to_array());
    PacketHit::new([0, 1, 2, 3].map(|lane| {
        let within = Interval {
            min: min[lane],
            max: f64::INFINITY,
        };
        let hit = is_set(wanted, lane).then(|| shape.hit(&alone[lane], within));
        hit.flatten().unwrap_or(Hit::NONE)
    }))
}
