//! `Triangle`.
//!
//! (Woop, Benthin and Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013.)

use glam::DVec3;

use super::{Bounds, Primitive, Rays};
use crate::lanes::{Lanes, NO_HIT, PacketHit, Vector3x4, positive, without};
use crate::vector::normalized;

/// Three corners, each with a shading normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// The corners.
    pub corners: [DVec3; 3],
    /// The shading normals of the corners, each of length 1.
    pub normals: [DVec3; 3],
    /// The geometric normal, of length 1.
    pub geometric_normal: DVec3,
    /// The square of the longest edge, divided by the least height.
    pub scale: f64,
}

/// Triangles that are narrower than this, in lengths of their longest edge, are
/// needles.
const NEEDLE: f64 = 1e-6;

impl Triangle {
    /// The shading normal at barycentric coordinates; the geometric one where the
    /// three normals cancel out.
    fn interpolated_normal(&self, beta: f64, gamma: f64) -> DVec3 {
        let [a, b, c] = self.normals;
        if self.is_flat() {
            return a;
        }
        let mean = a * (1.0 - beta - gamma) + b * beta + c * gamma;
        normalized(mean).unwrap_or(self.geometric_normal)
    }

    /// Whether the triangle is no needle. Rounding lets rays hit a needle far beyond its
    /// sharp tip.
    fn is_wide(&self) -> bool {
        let [a, b, c] = self.corners;
        let edges = [b - a, c - a, c - b].map(DVec3::length);
        let longest = edges.into_iter().fold(0.0, f64::max);
        let doubled_area = (b - a).cross(c - a).length();
        doubled_area > NEEDLE * longest * longest
    }

    fn is_flat(&self) -> bool {
        let [a, b, c] = self.normals;
        a == b && b == c
    }
}

/// The corners of four triangles, coordinate by coordinate.
pub(crate) type Corners = [[Lanes; 3]; 3];

impl Primitive for Triangle {
    type Four = Corners;

    fn support(self, along: DVec3) -> f64 {
        if !self.is_wide() {
            return f64::INFINITY;
        }
        let [a, b, c] = self.corners.map(|corner| corner.dot(along));
        a.max(b).max(c)
    }

    /// A ray in the plane of the triangle passes by the corners on both sides, but rounding
    /// alone weighs their depths. These are measured along the axis on which the ray goes
    /// farthest, where it advances by at least 1/√3 of its length.
    fn depth_error(self) -> f64 {
        let Bounds { min, max } = Bounds::around(self.corners);
        let extent = |axis: usize| max[axis] - min[axis];
        extent(0).max(extent(1)).max(extent(2)) * 3_f64.sqrt()
    }

    fn bounds(self) -> Bounds {
        if self.is_wide() {
            Bounds::around(self.corners)
        } else {
            Bounds::EVERYWHERE
        }
    }

    #[inline]
    fn four(shapes: [Self; 4]) -> Corners {
        [0, 1, 2].map(|corner| {
            let Vector3x4 { x, y, z } = Vector3x4::new(shapes.map(|shape| shape.corners[corner]));
            [x, y, z]
        })
    }

    #[inline]
    fn intersect(shapes: &Corners, rays: &Rays, _: u32) -> Lanes {
        let corners = shapes
            .each_ref()
            .map(|corner| rays.sheared().sheared(corner));
        let [u, v, w] = edge_functions(&corners);
        let zero = Lanes::ZERO;
        let right = u.simd_lt(zero) | v.simd_lt(zero) | w.simd_lt(zero);
        let left = u.simd_gt(zero) | v.simd_gt(zero) | w.simd_gt(zero);
        let missed = right & left;
        if missed.all() {
            return NO_HIT;
        }
        let [a, b, c] = corners;
        let determinant = u + v + w;
        let missed = missed | determinant.simd_eq(zero) | are_beside([a, b, c]);
        let z = (u * a[2] + v * b[2] + w * c[2]) / determinant;
        without(missed, positive(z * rays.sheared().t_of_z))
    }

    #[inline]
    fn hits(self, rays: &Rays, t: Lanes, _: u32) -> PacketHit {
        let geometric_normal = Vector3x4::splat(self.geometric_normal);
        let [a, b, c] = self.normals.map(Vector3x4::splat);
        let scale = Lanes::splat(self.scale);
        if self.is_flat() {
            return PacketHit {
                t,
                normal: a,
                geometric_normal,
                scale,
            };
        }
        let corners = Self::four([self; 4]);
        let corners = corners
            .each_ref()
            .map(|corner| rays.sheared().sheared(corner));
        let [u, v, w] = edge_functions(&corners);
        let determinant = u + v + w;
        let (beta, gamma) = (v / determinant, w / determinant);
        let mean = a * (Lanes::ONE - beta - gamma) + b * beta + c * gamma;
        let (mut normal, is_unit) = mean.normalized();
        if !(is_unit | t.is_nan()).all() {
            let (beta, gamma) = (beta.to_array(), gamma.to_array());
            let one = |lane: usize| self.interpolated_normal(beta[lane], gamma[lane]);
            normal = Vector3x4::new([0, 1, 2, 3].map(one));
        }
        PacketHit {
            t,
            normal,
            geometric_normal,
            scale,
        }
    }
}

/// Twice the areas between the ray and the edges, seen along the ray.
#[inline]
fn edge_functions([a, b, c]: &[[Lanes; 3]; 3]) -> [Lanes; 3] {
    [
        c[0] * b[1] - c[1] * b[0],
        a[0] * c[1] - a[1] * c[0],
        b[0] * a[1] - b[1] * a[0],
    ]
}

/// Whether all corners in sheared space lie on one side of the axis, in x or in y: then
/// signs of areas that say otherwise come from rounding.
#[inline]
fn are_beside([a, b, c]: [[Lanes; 3]; 3]) -> Lanes {
    let zero = Lanes::ZERO;
    let above = |axis: usize| a[axis].fast_min(b[axis]).fast_min(c[axis]).simd_gt(zero);
    let below = |axis: usize| a[axis].fast_max(b[axis]).fast_max(c[axis]).simd_lt(zero);
    above(0) | below(0) | above(1) | below(1)
}
