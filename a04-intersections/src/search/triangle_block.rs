//! `TriangleBlock`: four triangles side by side, which one instruction serves.

use wide::f64x4;

use super::shapes::{Shape, Shapes};
use super::tree::WIDTH;
use crate::triangle::ShearedRay;

/// Up to four triangles, and which these are.
#[derive(Debug)]
pub struct TriangleBlock {
    corners: [[f64x4; 3]; 3],
    pub triangles: [u32; WIDTH],
    /// A bit for each triangle that there is.
    present: u32,
}

/// A ray as Woop's test wants it, four times side by side.
pub struct TriangleRay {
    axes: [usize; 3],
    o: [f64x4; 3],
    shear: [f64x4; 2],
}

impl TriangleRay {
    #[inline]
    pub fn new(ray: &ShearedRay) -> Self {
        let ([x, y, z], [shear_x, shear_y]) = (ray.o, ray.shear);
        Self {
            axes: ray.axes,
            o: [f64x4::splat(x), f64x4::splat(y), f64x4::splat(z)],
            shear: [f64x4::splat(shear_x), f64x4::splat(shear_y)],
        }
    }

    #[inline]
    fn sheared(&self, corner: &[f64x4; 3]) -> (f64x4, f64x4) {
        let [x, y, z] = self.axes;
        let depth = corner[z] - self.o[2];
        (
            (corner[x] - self.o[0]) - self.shear[0] * depth,
            (corner[y] - self.o[1]) - self.shear[1] * depth,
        )
    }
}

impl TriangleBlock {
    pub fn new(shapes: &Shapes, block: &[Shape]) -> Self {
        let index = |lane: usize| match block.get(lane) {
            Some(Shape::Triangle(index)) => *index,
            _ => u32::MAX,
        };
        let lanes = |corner: usize, axis: usize| {
            let triangle = |lane| shapes.triangles.get(index(lane) as usize);
            let lane =
                |lane| triangle(lane).map_or(0.0, |(t, _)| t.corners[corner].to_glam()[axis]);
            f64x4::new(std::array::from_fn(lane))
        };
        Self {
            corners: [0, 1, 2].map(|corner| [0, 1, 2].map(|axis| lanes(corner, axis))),
            triangles: std::array::from_fn(index),
            present: (1 << block.len()) - 1,
        }
    }

    /// A bit for each triangle that the ray passes on the inner side of all its
    /// edges: the same operations in the same order as in `Triangle`, so that
    /// both agree.
    #[inline]
    pub fn met(&self, ray: &TriangleRay) -> u32 {
        let [a, b, c] = &self.corners;
        let ((ax, ay), (bx, by), (cx, cy)) = (ray.sheared(a), ray.sheared(b), ray.sheared(c));
        let u = cx * by - cy * bx;
        let v = ax * cy - ay * cx;
        let w = bx * ay - by * ax;
        let zero = f64x4::ZERO;
        let right = u.simd_lt(zero) | v.simd_lt(zero) | w.simd_lt(zero);
        let left = u.simd_gt(zero) | v.simd_gt(zero) | w.simd_gt(zero);
        self.present & !(right & left).to_bitmask()
    }
}
