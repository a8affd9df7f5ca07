//! `TriangleBlock`: four triangles side by side, which one instruction serves.

use a03_rays_cameras::Ray;
use wide::f64x4;

use super::tree::WIDTH;
use crate::Triangle;

/// Up to four triangles, with a number each.
#[derive(Debug)]
pub struct TriangleBlock {
    corners: [[f64x4; 3]; 3],
    pub numbers: [u32; WIDTH],
}

/// A ray as Woop's test wants it, four times side by side.
pub struct TriangleRay {
    /// The axes in an order that ends with the one along which it goes farthest.
    axes: [usize; 3],
    o: [f64x4; 3],
    shear: [f64x4; 2],
}

/// A corner of four triangles, sheared so that the ray is the z axis.
type Sheared = (f64x4, f64x4);

impl TriangleRay {
    #[inline]
    pub fn new(ray: &Ray) -> Self {
        let d = ray.direction().to_glam();
        let z = d.abs().max_position();
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let o = ray.origin().to_glam();
        Self {
            axes: [x, y, z],
            o: [f64x4::splat(o[x]), f64x4::splat(o[y]), f64x4::splat(o[z])],
            shear: [f64x4::splat(d[x] / d[z]), f64x4::splat(d[y] / d[z])],
        }
    }
}

impl TriangleRay {
    #[inline]
    fn shear(&self, corner: &[f64x4; 3]) -> Sheared {
        let [x, y, z] = self.axes;
        let depth = corner[z] - self.o[2];
        (
            (corner[x] - self.o[0]) - self.shear[0] * depth,
            (corner[y] - self.o[1]) - self.shear[1] * depth,
        )
    }
}

impl TriangleBlock {
    pub fn new(triangles: &[(Triangle, u32)]) -> Self {
        let lanes = |corner: usize, axis: usize| {
            let lane = |i: usize| {
                let triangle = triangles.get(i).map(|(triangle, _)| triangle);
                triangle.map_or(0.0, |t| t.corners()[corner].to_glam()[axis])
            };
            f64x4::new(std::array::from_fn(lane))
        };
        let number = |i: usize| triangles.get(i).map_or(u32::MAX, |(_, number)| *number);
        Self {
            corners: [0, 1, 2].map(|corner| [0, 1, 2].map(|axis| lanes(corner, axis))),
            numbers: std::array::from_fn(number),
        }
    }

    /// A bit for each triangle that the ray passes on the inner side of all its
    /// edges: the same operations in the same order as in [`Triangle`], so that
    /// both agree. A missing triangle is met as well.
    #[inline]
    pub fn met(&self, ray: &TriangleRay) -> u32 {
        let [a, b, c] = &self.corners;
        let ((ax, ay), (bx, by), (cx, cy)) = (ray.shear(a), ray.shear(b), ray.shear(c));
        let u = cx * by - cy * bx;
        let v = ax * cy - ay * cx;
        let w = bx * ay - by * ax;
        let zero = f64x4::ZERO;
        let right = u.simd_lt(zero) | v.simd_lt(zero) | w.simd_lt(zero);
        let left = u.simd_gt(zero) | v.simd_gt(zero) | w.simd_gt(zero);
        0b1111 & !(right & left).to_bitmask()
    }
}
