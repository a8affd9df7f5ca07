//! `AxisAlignedBox`.

use fearless_simd::prelude::*;
use glam::DVec3;

use super::{Primitive, Rays};
use crate::lanes::{Lanes, PacketHit, Vector3x4, first_positive, greater, lesser, splat, without};

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
pub(crate) struct Boxes<S: Simd> {
    min: Vector3x4<S>,
    max: Vector3x4<S>,
}

impl Primitive for &AxisAlignedBox {
    type Four<S: Simd> = Boxes<S>;

    fn support(self, along: DVec3) -> f64 {
        let farther = |axis: usize| {
            let (min, max) = (self.min[axis] * along[axis], self.max[axis] * along[axis]);
            min.max(max)
        };
        farther(0) + farther(1) + farther(2)
    }

    #[inline(always)]
    fn four<S: Simd>(simd: S, shapes: [Self; 4]) -> Boxes<S> {
        Boxes {
            min: Vector3x4::new(simd, shapes.map(|shape| shape.min.into())),
            max: Vector3x4::new(simd, shapes.map(|shape| shape.max.into())),
        }
    }

    #[inline(always)]
    fn intersect<S: Simd>(shapes: &Boxes<S>, rays: &Rays<S>, _: u32) -> Lanes<S> {
        shapes.hits(rays).t
    }

    #[inline(always)]
    fn hits<S: Simd>(self, rays: &Rays<S>, t: Lanes<S>, _: u32) -> PacketHit<S> {
        Self::four(t.simd, [self; 4]).hits(rays)
    }
}

impl<S: Simd> Boxes<S> {
    /// The hits of a ray and a box in each lane.
    #[inline(always)]
    fn hits(&self, rays: &Rays<S>) -> PacketHit<S> {
        let simd = rays.packet.simd();
        let (o, d) = (rays.packet.origin.axes(), rays.packet.direction.axes());
        let (min, max) = (self.min.axes(), self.max.axes());

        let (zero, one) = (splat(simd, 0.0), splat(simd, 1.0));
        let mut near = splat(simd, f64::NEG_INFINITY);
        let mut far = splat(simd, f64::INFINITY);
        // The outward normals of the faces that are entered and left.
        let (mut near_normal, mut far_normal) = ([zero; 3], [zero; 3]);
        for axis in 0..3 {
            let inverse = one / d[axis];
            let a = (min[axis] - o[axis]) * inverse;
            let b = (max[axis] - o[axis]) * inverse;
            // In this order the NaN of a ray within a face is dropped.
            let entered = lesser(greater(a, near), greater(b, near));
            let left = greater(lesser(a, far), lesser(b, far));
            let (later, earlier) = (entered.simd_gt(near), left.simd_lt(far));
            near = later.select(entered, near);
            far = earlier.select(left, far);
            for earlier_axis in 0..axis {
                near_normal[earlier_axis] = later.select(zero, near_normal[earlier_axis]);
                far_normal[earlier_axis] = earlier.select(zero, far_normal[earlier_axis]);
            }
            let along = one.copysign(d[axis]);
            near_normal[axis] = later.select(-along, zero);
            far_normal[axis] = earlier.select(along, zero);
        }
        let missed = near.simd_gt(far * WIDER);
        let far = greater(far, near);

        let enters = near.simd_gt(0.0);
        let normal = Vector3x4 {
            x: enters.select(near_normal[0], far_normal[0]),
            y: enters.select(near_normal[1], far_normal[1]),
            z: enters.select(near_normal[2], far_normal[2]),
        };
        let t = without(missed, first_positive(near, far));
        PacketHit::with_normals(t, normal, zero)
    }
}
