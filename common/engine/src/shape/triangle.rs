//! `Triangle`.
//!
//! (Woop, Benthin and Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013.)

use fearless_simd::prelude::*;
use glam::DVec3;

use super::{Bounds, Primitive, Rays};
use crate::lanes::{self, Lanes, Mask, PacketHit, Vector3x4, no_hit, positive, without};
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
pub(crate) type Corners<S> = [[Lanes<S>; 3]; 3];

impl Primitive for Triangle {
    type Four<S: Simd> = Corners<S>;

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

    #[inline(always)]
    fn four<S: Simd>(simd: S, shapes: [Self; 4]) -> Corners<S> {
        let [a, b, c] = [0, 1, 2].map(|corner| shapes.map(|shape| shape.corners[corner]));
        [
            Vector3x4::new(simd, a).axes(),
            Vector3x4::new(simd, b).axes(),
            Vector3x4::new(simd, c).axes(),
        ]
    }

    #[inline(always)]
    fn intersect<S: Simd>(shapes: &Corners<S>, rays: &Rays<S>, _: u32) -> Lanes<S> {
        let corners = sheared(shapes, rays);
        let [u, v, w] = edge_functions(&corners);
        let right = u.simd_lt(0.0) | v.simd_lt(0.0) | w.simd_lt(0.0);
        let left = u.simd_gt(0.0) | v.simd_gt(0.0) | w.simd_gt(0.0);
        let missed = right & left;
        if missed.all_true() {
            return no_hit(u.simd);
        }
        let determinant = u + v + w;
        let missed = missed | determinant.simd_eq(0.0) | are_beside(&corners);
        let [a, b, c] = corners;
        let z = (u * a[2] + v * b[2] + w * c[2]) / determinant;
        without(missed, positive(z * rays.sheared().t_of_z))
    }

    #[inline(always)]
    fn hits<S: Simd>(self, rays: &Rays<S>, t: Lanes<S>, _: u32) -> PacketHit<S> {
        let simd = t.simd;
        let geometric_normal = Vector3x4::splat(simd, self.geometric_normal);
        let [a, b, c] = self.normals;
        let a = Vector3x4::splat(simd, a);
        let b = Vector3x4::splat(simd, b);
        let c = Vector3x4::splat(simd, c);
        let scale = lanes::splat(simd, self.scale);
        if self.is_flat() {
            return PacketHit {
                t,
                normal: a,
                geometric_normal,
                scale,
            };
        }
        let corners = sheared(&splat(simd, self.corners), rays);
        let [u, v, w] = edge_functions(&corners);
        let determinant = u + v + w;
        let (beta, gamma) = (v / determinant, w / determinant);
        let mean = a * (1.0 - beta - gamma) + b * beta + c * gamma;
        let (mut normal, is_unit) = mean.normalized();
        if !(is_unit | t.is_nan()).all_true() {
            let one = |lane: usize| self.interpolated_normal(beta[lane], gamma[lane]);
            normal = Vector3x4::new(simd, [0, 1, 2, 3].map(one));
        }
        PacketHit {
            t,
            normal,
            geometric_normal,
            scale,
        }
    }
}

/// The corners of one triangle, four times.
#[inline(always)]
pub(super) fn splat<S: Simd>(simd: S, [a, b, c]: [DVec3; 3]) -> Corners<S> {
    [
        Vector3x4::splat(simd, a).axes(),
        Vector3x4::splat(simd, b).axes(),
        Vector3x4::splat(simd, c).axes(),
    ]
}

/// The corners in the sheared spaces of the rays.
#[inline(always)]
fn sheared<S: Simd>([a, b, c]: &Corners<S>, rays: &Rays<S>) -> Corners<S> {
    let rays = rays.sheared();
    [rays.sheared(a), rays.sheared(b), rays.sheared(c)]
}

/// Twice the areas between the ray and the edges, seen along the ray.
#[inline(always)]
fn edge_functions<S: Simd>([a, b, c]: &Corners<S>) -> [Lanes<S>; 3] {
    [
        c[0] * b[1] - c[1] * b[0],
        a[0] * c[1] - a[1] * c[0],
        b[0] * a[1] - b[1] * a[0],
    ]
}

/// Whether all corners in sheared space lie on one side of the axis, in x or in y: then
/// signs of areas that say otherwise come from rounding.
#[inline(always)]
fn are_beside<S: Simd>([a, b, c]: &Corners<S>) -> Mask<S> {
    let right = a[0].simd_gt(0.0) & b[0].simd_gt(0.0) & c[0].simd_gt(0.0);
    let left = a[0].simd_lt(0.0) & b[0].simd_lt(0.0) & c[0].simd_lt(0.0);
    let above = a[1].simd_gt(0.0) & b[1].simd_gt(0.0) & c[1].simd_gt(0.0);
    let below = a[1].simd_lt(0.0) & b[1].simd_lt(0.0) & c[1].simd_lt(0.0);
    right | left | above | below
}
