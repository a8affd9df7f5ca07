//! `AxisAlignedBox`.

use glam::DVec3;

use super::{Primitive, Rays};
use crate::lanes::{Lanes, PacketHit, Vector3x4, copysign, first_positive, select, without};

/// A box whose faces are perpendicular to the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisAlignedBox {
    /// The least coordinates.
    pub min: [f64; 3],
    /// The greatest coordinates.
    pub max: [f64; 3],
}

/// The upper bound of a slab is widened by twice `γ(3) = 3u / (1 - 3u)`, with
/// `u = 2^-53` (Ize, Robust BVH Ray Traversal, JCGT 2(2), 2013).
const WIDER: f64 = {
    let three_u = 1.5 * f64::EPSILON;
    1.0 + 2.0 * (three_u / (1.0 - three_u))
};

/// Four boxes.
pub(crate) struct Boxes {
    min: [Lanes; 3],
    max: [Lanes; 3],
}

impl Primitive for &AxisAlignedBox {
    type Four = Boxes;

    fn support(self, along: DVec3) -> f64 {
        let farther = |axis: usize| {
            let (min, max) = (self.min[axis] * along[axis], self.max[axis] * along[axis]);
            min.max(max)
        };
        farther(0) + farther(1) + farther(2)
    }

    #[inline]
    fn four(shapes: [Self; 4]) -> Boxes {
        Boxes {
            min: [0, 1, 2].map(|axis| Lanes::new(shapes.map(|shape| shape.min[axis]))),
            max: [0, 1, 2].map(|axis| Lanes::new(shapes.map(|shape| shape.max[axis]))),
        }
    }

    #[inline]
    fn intersect(shapes: &Boxes, rays: &Rays, _: u32) -> Lanes {
        shapes.hits(rays).t
    }

    #[inline]
    fn hits(self, rays: &Rays, _: Lanes, _: u32) -> PacketHit {
        Self::four([self; 4]).hits(rays)
    }
}

impl Boxes {
    /// The hits of a ray and a box in each lane.
    #[inline]
    fn hits(&self, rays: &Rays) -> PacketHit {
        let coordinates = |v: Vector3x4| [v.x, v.y, v.z];
        let (o, d) = (rays.packet.origin, rays.packet.direction);
        let (o, d) = (coordinates(o), coordinates(d));

        let mut near = Lanes::splat(f64::NEG_INFINITY);
        let mut far = Lanes::splat(f64::INFINITY);
        // The outward normals of the faces that are entered and left.
        let (mut near_normal, mut far_normal) = ([Lanes::ZERO; 3], [Lanes::ZERO; 3]);
        for axis in 0..3 {
            let inverse = Lanes::ONE / d[axis];
            let a = (self.min[axis] - o[axis]) * inverse;
            let b = (self.max[axis] - o[axis]) * inverse;
            // In this order `min` and `max` drop the NaN of a ray within a face.
            let entered = a.max(near).fast_min(b.max(near));
            let left = a.min(far).fast_max(b.min(far));
            let (later, earlier) = (entered.simd_gt(near), left.simd_lt(far));
            near = select(later, entered, near);
            far = select(earlier, left, far);
            for earlier_axis in 0..axis {
                near_normal[earlier_axis] &= !later;
                far_normal[earlier_axis] &= !earlier;
            }
            let along = copysign(Lanes::ONE, d[axis]);
            near_normal[axis] = -along & later;
            far_normal[axis] = along & earlier;
        }
        let missed = near.simd_gt(far * Lanes::splat(WIDER));
        let far = far.fast_max(near);

        let enters = near.simd_gt(Lanes::ZERO);
        let [x, y, z] = [0, 1, 2].map(|axis| select(enters, near_normal[axis], far_normal[axis]));
        let t = without(missed, first_positive(near, far));
        PacketHit::with_normals(t, Vector3x4 { x, y, z }, Lanes::ZERO)
    }
}
