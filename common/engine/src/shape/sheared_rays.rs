//! `ShearedRays`: rays about to be tested against triangles.
//!
//! Space is sheared so that the ray is the z axis, and z measured in a power of two of `t`. (Woop,
//! Benthin and Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013.)

use fearless_simd::prelude::*;

use crate::lanes::{
    Lanes, Mask, RayPacket, Vector3x4, bits_of, is_square_for_formulas, powers_of_two, splat,
};

/// Four sheared rays.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShearedRays<S: Simd> {
    axes: Axes<S>,
    origin: [Lanes<S>; 3],
    shear: [Lanes<S>; 2],
    scale_z: Lanes<S>,
    /// `t` of the rays for 1 of `z`: powers of two, which round nothing.
    pub t_of_z: Lanes<S>,
}

/// The axes x, y and z of the sheared spaces.
#[derive(Clone, Copy, Debug)]
enum Axes<S: Simd> {
    Same([usize; 3]),
    /// Masks of the rays that go farthest along the first axis, and along the second.
    Mixed([Mask<S>; 2]),
}

impl<S: Simd> Axes<S> {
    /// Of rays with these directions; only the active ones count.
    #[inline(always)]
    fn new(direction: Vector3x4<S>, active: u32) -> Self {
        let Vector3x4 { x, y, z } = direction.abs();
        let beyond_x = y.simd_gt(x);
        let third = z.simd_gt(beyond_x.select(y, x));
        let masks = [!(beyond_x | third), beyond_x & !third, third];
        let is_of_all = |mask: &Mask<S>| active & !bits_of(*mask) == 0;
        match masks.iter().position(is_of_all) {
            Some(z) => Self::Same([(z + 1) % 3, (z + 2) % 3, z]),
            None => Self::Mixed([masks[0], masks[1]]),
        }
    }

    /// The coordinates along the axes x, y and z.
    #[inline(always)]
    fn along(self, coordinates: &[Lanes<S>; 3]) -> [Lanes<S>; 3] {
        match self {
            Self::Same([x, y, z]) => [coordinates[x], coordinates[y], coordinates[z]],
            Self::Mixed([first, second]) => {
                let [a, b, c] = *coordinates;
                [
                    first.select(b, second.select(c, a)),
                    first.select(c, second.select(a, b)),
                    first.select(a, second.select(b, c)),
                ]
            }
        }
    }
}

impl<S: Simd> ShearedRays<S> {
    #[inline(always)]
    pub fn new(rays: &RayPacket<S>, active: u32) -> Self {
        let RayPacket { origin, direction } = *rays;
        let axes = Axes::new(direction, active);
        let [x, y, z] = axes.along(&direction.axes());
        // Areas times depths in `t` might be infinite or 0.
        let inverse = 1.0 / z;
        let is_plain = is_square_for_formulas(inverse * inverse);
        let unit = is_plain.select(splat(z.simd, 1.0), powers_of_two(z));
        Self {
            axes,
            origin: axes.along(&origin.axes()),
            shear: [x / z, y / z],
            scale_z: unit / z,
            t_of_z: 1.0 / unit,
        }
    }

    /// A point for each ray, in its sheared space.
    #[inline(always)]
    pub fn sheared(&self, point: &[Lanes<S>; 3]) -> [Lanes<S>; 3] {
        let [x, y, z] = self.axes.along(point);
        let depth = z - self.origin[2];
        [
            (x - self.origin[0]) - self.shear[0] * depth,
            (y - self.origin[1]) - self.shear[1] * depth,
            self.scale_z * depth,
        ]
    }
}
