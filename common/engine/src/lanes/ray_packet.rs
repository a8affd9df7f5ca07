//! `RayPacket`: four rays side by side, and `PacketHit`: their hits.
//!
//! Rays through neighbouring pixels meet much the same objects, so they are traced
//! together (Wald, Slusallek, Benthin and Wagner, Interactive Rendering with Coherent
//! Ray Tracing, 2001).

use fearless_simd::prelude::*;

use super::{Lanes, Mask, Vector3x4, greater, is_square_for_formulas, lanes, splat};
use crate::vector::scaled;
use crate::{Hit, Ray};

/// Bound of the rounding error of a hit along the normal, in units of the largest number that the
/// hit was computed from.
pub const OFFSET: f64 = 64.0 * f64::EPSILON;

/// Four rays.
#[derive(Clone, Copy, Debug)]
pub struct RayPacket<S: Simd> {
    /// The origins.
    pub origin: Vector3x4<S>,
    /// The directions.
    pub direction: Vector3x4<S>,
}

impl<S: Simd> RayPacket<S> {
    /// These four rays.
    #[inline(always)]
    pub fn new(simd: S, rays: [&Ray; 4]) -> Self {
        Self {
            origin: Vector3x4::new(simd, rays.map(|ray| ray.origin)),
            direction: Vector3x4::new(simd, rays.map(|ray| ray.direction)),
        }
    }

    /// The instructions for these lanes.
    #[inline(always)]
    pub fn simd(&self) -> S {
        self.origin.x.simd
    }

    /// The four rays, one by one.
    #[inline(always)]
    pub fn to_rays(self) -> [Ray; 4] {
        let (origins, directions) = (self.origin.to_lanes(), self.direction.to_lanes());
        let ray = |lane: usize| Ray {
            origin: origins[lane],
            direction: directions[lane],
        };
        [ray(0), ray(1), ray(2), ray(3)]
    }

    /// These rays, where the first active one replaces those that are not active.
    #[inline(always)]
    pub fn filled(self, active: u32) -> Self {
        if active == 0b1111 {
            return self;
        }
        Self {
            origin: self.origin.filled(active),
            direction: self.direction.filled(active),
        }
    }

    /// These rays, where directions that are too long or too short for formulas are divided by
    /// powers of two, so that they are about as long as 1; and these powers, 1 for the others.
    pub fn scaled(self) -> (Self, Lanes<S>) {
        let simd = self.simd();
        let is_plain = is_square_for_formulas(self.direction.dot(self.direction));
        if is_plain.all_true() {
            return (self, splat(simd, 1.0));
        }
        let scaled = (self.direction.to_lanes()).map(|v| scaled(v).unwrap_or((v, 1.0)));
        let direction = Vector3x4::new(simd, scaled.map(|(direction, _)| direction));
        let unit = lanes(simd, scaled.map(|(_, unit)| unit));
        let rays = Self {
            direction: self.direction.or(is_plain, direction),
            ..self
        };
        (rays, is_plain.select(splat(simd, 1.0), unit))
    }

    /// The points `origin + t direction`.
    #[inline(always)]
    pub fn at(&self, t: Lanes<S>) -> Vector3x4<S> {
        self.origin + self.direction * t
    }
}

/// Up to four hits.
#[derive(Clone, Copy, Debug)]
pub struct PacketHit<S: Simd> {
    /// The `t` of the hits: above 0. NaN in lanes without a hit.
    pub t: Lanes<S>,
    /// The shading normals.
    pub normal: Vector3x4<S>,
    /// The geometric normals.
    pub geometric_normal: Vector3x4<S>,
    /// How large the numbers of the shapes are, as lengths along the geometric normals.
    pub scale: Lanes<S>,
}

impl<S: Simd> PacketHit<S> {
    /// These four hits.
    #[inline(always)]
    pub fn new(simd: S, hits: [Hit; 4]) -> Self {
        Self {
            t: lanes(simd, hits.map(|hit| hit.t)),
            normal: Vector3x4::new(simd, hits.map(|hit| hit.normal)),
            geometric_normal: Vector3x4::new(simd, hits.map(|hit| hit.geometric_normal)),
            scale: lanes(simd, hits.map(|hit| hit.scale)),
        }
    }

    /// Hits at these `t`, of these scales, whose shading normals are the geometric ones.
    #[inline(always)]
    pub fn with_normals(t: Lanes<S>, normal: Vector3x4<S>, scale: Lanes<S>) -> Self {
        Self {
            t,
            normal,
            geometric_normal: normal,
            scale,
        }
    }

    /// The four hits, one by one.
    #[inline(always)]
    pub fn to_hits(self) -> [Hit; 4] {
        let (normals, faces) = (self.normal.to_lanes(), self.geometric_normal.to_lanes());
        let hit = |lane: usize| Hit {
            t: self.t[lane],
            normal: normals[lane],
            geometric_normal: faces[lane],
            scale: self.scale[lane],
        };
        [hit(0), hit(1), hit(2), hit(3)]
    }

    /// These hits in the lanes of the mask, and `others` in the other lanes.
    #[inline(always)]
    pub fn or(self, mask: Mask<S>, others: Self) -> Self {
        Self {
            t: mask.select(self.t, others.t),
            normal: self.normal.or(mask, others.normal),
            geometric_normal: self.geometric_normal.or(mask, others.geometric_normal),
            scale: mask.select(self.scale, others.scale),
        }
    }

    /// The greatest distances of the computed hits from their surfaces.
    #[inline(always)]
    pub fn rounding_error(&self, rays: &RayPacket<S>) -> Lanes<S> {
        let largest = rays
            .origin
            .largest_coordinate()
            .max(rays.at(self.t).largest_coordinate())
            .max(self.t);
        // A shape of a student's own may have the scale NaN, which the lesson drops.
        greater(self.scale, largest) * OFFSET
    }

    /// The hits with their normals turned against the directions of the rays.
    #[inline(always)]
    pub fn facing(self, rays: &RayPacket<S>) -> Self {
        let from_behind = self.geometric_normal.dot(rays.direction).simd_gt(0.0);
        Self {
            normal: self.normal.negated(from_behind),
            geometric_normal: self.geometric_normal.negated(from_behind),
            ..self
        }
    }
}
