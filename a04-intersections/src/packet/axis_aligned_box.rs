//! Four rays and a box.

use a02_math::vector3x4::select;
use a02_math::{Lanes, Vector3x4};
use a03_rays_cameras::RayPacket;

use super::{PacketHit, copysign, first_ahead, without};
use crate::AxisAlignedBox;
use crate::axis_aligned_box::WIDER;

impl AxisAlignedBox {
    /// Where each ray meets the box.
    #[inline(never)]
    pub(crate) fn meet(&self, rays: &RayPacket) -> Lanes {
        self.hits(rays).t
    }

    /// The same with all that there is to these hits.
    #[inline]
    pub(crate) fn hits(&self, rays: &RayPacket) -> PacketHit {
        let coordinates = |v: Vector3x4| [v.x, v.y, v.z];
        let (o, d) = (coordinates(rays.origin), coordinates(rays.direction));

        let mut near = Lanes::splat(f64::NEG_INFINITY);
        let mut far = Lanes::splat(f64::INFINITY);
        // The outward normals of the faces that are entered and left.
        let (mut near_normal, mut far_normal) = ([Lanes::ZERO; 3], [Lanes::ZERO; 3]);
        for axis in 0..3 {
            let inverse = Lanes::ONE / d[axis];
            let a = (Lanes::splat(self.lbf[axis]) - o[axis]) * inverse;
            let b = (Lanes::splat(self.run[axis]) - o[axis]) * inverse;
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
        let normal = Vector3x4 { x, y, z };
        PacketHit {
            t: without(missed, first_ahead(near, far)),
            normal,
            face: normal,
        }
    }
}
