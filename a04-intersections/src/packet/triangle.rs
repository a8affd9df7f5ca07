//! Four rays and a triangle.

use a02_math::{Lanes, Vector3x4};
use a03_rays_cameras::RayPacket;

use super::{PacketHit, ahead, without};
use crate::Triangle;
use crate::triangle::ShearedRay;

/// Four rays as Woop's test wants them.
#[derive(Clone, Copy, Debug)]
pub struct ShearedRays {
    axes: [usize; 3],
    o: [Lanes; 3],
    shear: [Lanes; 2],
    scale_z: Lanes,
}

impl ShearedRays {
    /// The rays whose bits are set in `active`. None if they do not go farthest
    /// along the same axis.
    #[inline]
    pub fn new(rays: &RayPacket, active: u32) -> Option<Self> {
        let rays = rays.to_rays().map(|ray| ShearedRay::new(&ray));
        let axes = rays[active.trailing_zeros() as usize % 4].axes;
        let is_like_them = |lane: usize| active >> lane & 1 == 0 || rays[lane].axes == axes;
        (0..4).all(is_like_them).then(|| Self {
            axes,
            o: [0, 1, 2].map(|axis| Lanes::new(rays.map(|ray| ray.o[axis]))),
            shear: [0, 1].map(|axis| Lanes::new(rays.map(|ray| ray.shear[axis]))),
            scale_z: Lanes::new(rays.map(|ray| ray.scale_z)),
        })
    }

    #[inline]
    fn sheared(&self, corner: [f64; 3]) -> [Lanes; 3] {
        let [x, y, z] = self.axes.map(|axis| Lanes::splat(corner[axis]));
        let depth = z - self.o[2];
        [
            (x - self.o[0]) - self.shear[0] * depth,
            (y - self.o[1]) - self.shear[1] * depth,
            self.scale_z * depth,
        ]
    }
}

/// Where on four rays, and where on a triangle.
#[derive(Clone, Copy, Debug)]
pub struct Barycentric {
    pub t: Lanes,
    beta: Lanes,
    gamma: Lanes,
}

/// See `is_far_beside`, beside the triangle.
#[inline]
fn are_far_beside([a, b, c]: [[Lanes; 3]; 3]) -> Lanes {
    let least = |axis: usize| a[axis].fast_min(b[axis]).fast_min(c[axis]);
    let most = |axis: usize| a[axis].fast_max(b[axis]).fast_max(c[axis]);
    let (low, high) = ([least(0), least(1)], [most(0), most(1)]);
    let largest = |axis: usize| high[axis].fast_max(-low[axis]);
    let half = largest(0).fast_max(largest(1)) / Lanes::splat(2.0);
    let beyond = |axis: usize| low[axis].simd_gt(half) | high[axis].simd_lt(-half);
    beyond(0) | beyond(1)
}

impl Triangle {
    /// Where each ray meets the triangle.
    #[inline(never)]
    pub(crate) fn meet(&self, rays: &ShearedRays) -> Barycentric {
        let corners = self.corners.map(|corner| corner.to_glam().to_array());
        let [a, b, c] = corners.map(|corner| rays.sheared(corner));

        let zero = Lanes::ZERO;
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        let right = u.simd_lt(zero) | v.simd_lt(zero) | w.simd_lt(zero);
        let left = u.simd_gt(zero) | v.simd_gt(zero) | w.simd_gt(zero);
        let determinant = u + v + w;
        let missed = (right & left) | determinant.simd_eq(zero) | are_far_beside([a, b, c]);

        let t = (u * a[2] + v * b[2] + w * c[2]) / determinant;
        Barycentric {
            t: without(missed, ahead(t)),
            beta: v / determinant,
            gamma: w / determinant,
        }
    }

    /// All that there is to these hits.
    #[inline]
    pub(crate) fn hits(&self, at: Barycentric) -> PacketHit {
        let Barycentric { t, beta, gamma } = at;
        let [a, b, c] = self
            .normals
            .map(|normal| Vector3x4::splat(normal.to_glam()));
        let mut normal = a;
        if !self.is_flat() {
            let mean = a * (Lanes::ONE - beta - gamma) + b * beta + c * gamma;
            let (unit, is_unit) = mean.normalized();
            normal = unit;
            if !(is_unit | t.is_nan()).all() {
                let (beta, gamma) = (beta.to_array(), gamma.to_array());
                let one = |lane: usize| self.interpolated_normal(beta[lane], gamma[lane]);
                normal = Vector3x4::new([0, 1, 2, 3].map(|lane| one(lane).to_glam()));
            }
        }
        PacketHit {
            t,
            normal,
            face: Vector3x4::splat(self.face.to_glam()),
        }
    }
}
