//! `ShearedRays`: rays about to be tested against triangles.
//!
//! Space is sheared so that the ray is the z axis, and z measured in a power of two of `t`. (Woop,
//! Benthin and Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013.)

use crate::lanes::{Lanes, RayPacket, Vector3x4, is_square_for_formulas, powers_of_two, select};

/// Four sheared rays.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShearedRays {
    axes: Axes,
    origin: [Lanes; 3],
    shear: [Lanes; 2],
    scale_z: Lanes,
    /// `t` of the rays for 1 of `z`: powers of two, which round nothing.
    pub t_of_z: Lanes,
}

/// The axes x, y and z of the sheared spaces.
#[derive(Clone, Copy, Debug)]
enum Axes {
    Same([usize; 3]),
    /// Masks of the rays that go farthest along the first axis, and along the second.
    Mixed([Lanes; 2]),
}

impl Axes {
    /// Of rays with these directions; only the active ones count.
    #[inline]
    fn new(direction: Vector3x4, active: u32) -> Self {
        let [x, y, z] = [direction.x, direction.y, direction.z].map(Lanes::abs);
        let beyond_x = y.simd_gt(x);
        let third = z.simd_gt(select(beyond_x, y, x));
        let masks = [!(beyond_x | third), beyond_x & !third, third];
        let is_of_all = |mask: &Lanes| active & !mask.to_bitmask() == 0;
        match masks.iter().position(is_of_all) {
            Some(z) => Self::Same([(z + 1) % 3, (z + 2) % 3, z]),
            None => Self::Mixed([masks[0], masks[1]]),
        }
    }

    /// The coordinates along the axes x, y and z.
    #[inline]
    fn along(self, coordinates: &[Lanes; 3]) -> [Lanes; 3] {
        match self {
            Self::Same(axes) => axes.map(|axis| coordinates[axis]),
            Self::Mixed([first, second]) => [1, 2, 0].map(|of_first| {
                let [a, b, c] = [0, 1, 2].map(|axis| coordinates[(of_first + axis) % 3]);
                select(first, a, select(second, b, c))
            }),
        }
    }
}

impl ShearedRays {
    #[inline]
    pub fn new(rays: &RayPacket, active: u32) -> Self {
        let RayPacket { origin, direction } = *rays;
        let axes = Axes::new(direction, active);
        let [x, y, z] = axes.along(&[direction.x, direction.y, direction.z]);
        // Areas times depths in `t` might be infinite or 0.
        let inverse = Lanes::ONE / z;
        let is_plain = is_square_for_formulas(inverse * inverse);
        let unit = select(is_plain, Lanes::ONE, powers_of_two(z));
        Self {
            axes,
            origin: axes.along(&[origin.x, origin.y, origin.z]),
            shear: [x / z, y / z],
            scale_z: unit / z,
            t_of_z: Lanes::ONE / unit,
        }
    }

    /// A point for each ray, in its sheared space.
    #[inline]
    pub fn sheared(&self, point: &[Lanes; 3]) -> [Lanes; 3] {
        let [x, y, z] = self.axes.along(point);
        let depth = z - self.origin[2];
        [
            (x - self.origin[0]) - self.shear[0] * depth,
            (y - self.origin[1]) - self.shear[1] * depth,
            self.scale_z * depth,
        ]
    }
}
