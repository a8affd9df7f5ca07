//! `TriangleBlock`: four triangles of a leaf, tested against one ray.

use glam::DVec3;

use super::Triangle;
use super::sheared_ray::ShearedRay;
use crate::accel::WIDTH;
use crate::lanes::{Lanes, Vector3x4};

/// Up to four triangles, and their indices.
#[derive(Debug)]
pub(crate) struct TriangleBlock {
    corners: [[Lanes; 3]; 3],
    /// The index of each triangle; `u32::MAX` in lanes without one.
    pub indices: [u32; WIDTH],
    /// A bit for each lane that holds a triangle.
    present: u32,
}

/// A sheared ray, four times side by side.
pub(crate) struct TriangleRay {
    axes: [usize; 3],
    origin: [Lanes; 3],
    shear: [Lanes; 2],
}

impl TriangleRay {
    #[inline]
    pub fn new(ray: &ShearedRay) -> Self {
        Self {
            axes: ray.axes,
            origin: ray.origin.map(Lanes::splat),
            shear: ray.shear.map(Lanes::splat),
        }
    }

    #[inline]
    fn sheared(&self, corner: &[Lanes; 3]) -> (Lanes, Lanes) {
        let [x, y, z] = self.axes;
        let depth = corner[z] - self.origin[2];
        (
            (corner[x] - self.origin[0]) - self.shear[0] * depth,
            (corner[y] - self.origin[1]) - self.shear[1] * depth,
        )
    }
}

impl TriangleBlock {
    /// The triangles of these indices.
    pub fn new(indices: [u32; WIDTH], triangle: impl Fn(u32) -> Option<Triangle>) -> Self {
        let triangles = indices.map(triangle);
        let corner = |i: usize| {
            let corners = triangles.map(|t| t.map_or(DVec3::ZERO, |t| t.corners[i]));
            let Vector3x4 { x, y, z } = Vector3x4::new(corners);
            [x, y, z]
        };
        let bit = |lane: usize| u32::from(triangles[lane].is_some()) << lane;
        Self {
            corners: [0, 1, 2].map(corner),
            indices,
            present: (0..WIDTH).map(bit).sum(),
        }
    }

    /// A bit for each triangle that the ray passes on the inner side of all its edges:
    /// the operations of [`Triangle::hit`], in their order.
    #[inline]
    pub fn candidates(&self, ray: &TriangleRay) -> u32 {
        let [(ax, ay), (bx, by), (cx, cy)] = self.corners.each_ref().map(|c| ray.sheared(c));
        let u = cx * by - cy * bx;
        let v = ax * cy - ay * cx;
        let w = bx * ay - by * ax;
        let zero = Lanes::ZERO;
        let right = u.simd_lt(zero) | v.simd_lt(zero) | w.simd_lt(zero);
        let left = u.simd_gt(zero) | v.simd_gt(zero) | w.simd_gt(zero);
        self.present & !(right & left).to_bitmask()
    }
}
