//! `Triangle`: for one ray, and for four rays that are sheared together.
//!
//! (Woop, Benthin and Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013.)

use glam::DVec3;

use super::Bounds;
use super::sheared_ray::{ShearedRay, ShearedRays};
use crate::lanes::{Lanes, PacketHit, Vector3x4, ahead, without};
use crate::vector::normalized;
use crate::{Hit, Interval};

/// Three corners, each with a shading normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// The corners.
    pub corners: [DVec3; 3],
    /// The shading normals of the corners, each of length 1.
    pub normals: [DVec3; 3],
    /// The geometric normal, of length 1.
    pub face: DVec3,
}

/// Triangles that are narrower than this, in lengths of their longest edge, are
/// needles.
const NEEDLE: f64 = 1e-6;

impl Triangle {
    /// The bounds; all of space for a needle, because rounding lets rays hit it far
    /// beyond its sharp tip.
    pub(crate) fn bounds(&self) -> Bounds {
        let [a, b, c] = self.corners;
        let edges = [b - a, c - a, c - b].map(DVec3::length);
        let longest = edges.into_iter().fold(0.0, f64::max);
        let doubled_area = (b - a).cross(c - a).length();
        if doubled_area > NEEDLE * longest * longest {
            Bounds::around(self.corners)
        } else {
            Bounds::EVERYWHERE
        }
    }

    /// The shading normal at barycentric coordinates; the geometric one where the
    /// three normals cancel out.
    fn interpolated_normal(&self, beta: f64, gamma: f64) -> DVec3 {
        let [a, b, c] = self.normals;
        if self.is_flat() {
            return a;
        }
        let mean = a * (1.0 - beta - gamma) + b * beta + c * gamma;
        normalized(mean).unwrap_or(self.face)
    }

    fn is_flat(&self) -> bool {
        let [a, b, c] = self.normals;
        a == b && b == c
    }

    #[inline]
    pub(crate) fn hit(&self, ray: &ShearedRay, within: Interval) -> Option<Hit> {
        let [a, b, c] = self.corners.map(|corner| ray.sheared(corner));
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
            return None;
        }
        let determinant = u + v + w;
        if determinant == 0.0 || is_beside([a, b, c]) {
            return None;
        }
        let t = (u * a[2] + v * b[2] + w * c[2]) / determinant;
        within.contains(t).then(|| Hit {
            t,
            normal: self.interpolated_normal(v / determinant, w / determinant),
            face: self.face,
        })
    }

    /// Where each of four rays meets the triangle.
    #[inline(never)]
    pub(crate) fn meet(&self, rays: &ShearedRays) -> Barycentric {
        let [a, b, c] = self.corners.map(|corner| rays.sheared(corner));
        let zero = Lanes::ZERO;
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        let right = u.simd_lt(zero) | v.simd_lt(zero) | w.simd_lt(zero);
        let left = u.simd_gt(zero) | v.simd_gt(zero) | w.simd_gt(zero);
        let determinant = u + v + w;
        let missed = (right & left) | determinant.simd_eq(zero) | are_beside([a, b, c]);

        let t = (u * a[2] + v * b[2] + w * c[2]) / determinant;
        Barycentric {
            t: without(missed, ahead(t)),
            beta: v / determinant,
            gamma: w / determinant,
        }
    }

    /// The hits at these places.
    #[inline]
    pub(crate) fn hits(&self, at: Barycentric) -> PacketHit {
        let Barycentric { t, beta, gamma } = at;
        let [a, b, c] = self.normals.map(Vector3x4::splat);
        let mut normal = a;
        if !self.is_flat() {
            let mean = a * (Lanes::ONE - beta - gamma) + b * beta + c * gamma;
            let (unit, is_unit) = mean.normalized();
            normal = unit;
            if !(is_unit | t.is_nan()).all() {
                let (beta, gamma) = (beta.to_array(), gamma.to_array());
                let one = |lane: usize| self.interpolated_normal(beta[lane], gamma[lane]);
                normal = Vector3x4::new([0, 1, 2, 3].map(one));
            }
        }
        PacketHit {
            t,
            normal,
            face: Vector3x4::splat(self.face),
        }
    }
}

/// Where on four rays, and where on a triangle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Barycentric {
    pub t: Lanes,
    beta: Lanes,
    gamma: Lanes,
}

/// Whether all corners in sheared space lie on one side of the axis, in x or in y: then
/// signs of areas that say otherwise come from rounding.
fn is_beside(corners: [[f64; 3]; 3]) -> bool {
    let all = |axis: usize, sign: f64| corners.iter().all(|c| sign * c[axis] > 0.0);
    all(0, 1.0) || all(0, -1.0) || all(1, 1.0) || all(1, -1.0)
}

/// Like `is_beside`, for four rays.
#[inline]
fn are_beside([a, b, c]: [[Lanes; 3]; 3]) -> Lanes {
    let zero = Lanes::ZERO;
    let above = |axis: usize| a[axis].fast_min(b[axis]).fast_min(c[axis]).simd_gt(zero);
    let below = |axis: usize| a[axis].fast_max(b[axis]).fast_max(c[axis]).simd_lt(zero);
    above(0) | below(0) | above(1) | below(1)
}
