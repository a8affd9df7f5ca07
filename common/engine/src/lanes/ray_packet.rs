//! `RayPacket`: four rays side by side, and `PacketHit`: their hits.
//!
//! Rays through neighbouring pixels meet much the same objects, so they are traced
//! together (Wald, Slusallek, Benthin and Wagner, Interactive Rendering with Coherent
//! Ray Tracing, 2001).

use super::{Lanes, Vector3x4, is_square_for_formulas, mask, select};
use crate::vector::scaled;
use crate::{Hit, Ray};

/// Bound of the rounding error of a hit along the normal, in units of the largest number that the
/// hit was computed from.
pub const OFFSET: f64 = 64.0 * f64::EPSILON;

/// Four rays.
#[derive(Clone, Copy, Debug)]
pub struct RayPacket {
    /// The origins.
    pub origin: Vector3x4,
    /// The directions.
    pub direction: Vector3x4,
}

impl RayPacket {
    /// These four rays.
    #[inline]
    pub fn new(rays: [&Ray; 4]) -> Self {
        Self {
            origin: Vector3x4::new(rays.map(|ray| ray.origin)),
            direction: Vector3x4::new(rays.map(|ray| ray.direction)),
        }
    }

    /// The four rays, one by one.
    #[inline]
    pub fn to_rays(self) -> [Ray; 4] {
        let (origins, directions) = (self.origin.to_lanes(), self.direction.to_lanes());
        [0, 1, 2, 3].map(|lane| Ray {
            origin: origins[lane],
            direction: directions[lane],
        })
    }

    /// These rays, where the first active one replaces those that are not active.
    #[inline]
    pub fn filled(self, active: u32) -> Self {
        if active == 0b1111 {
            return self;
        }
        let first = active.trailing_zeros() as usize % 4;
        let fill = |vectors: Vector3x4| {
            vectors.or(mask(active), Vector3x4::splat(vectors.to_lanes()[first]))
        };
        Self {
            origin: fill(self.origin),
            direction: fill(self.direction),
        }
    }

    /// These rays, where directions that are too long or too short for formulas are divided by
    /// powers of two, so that they are about as long as 1; and these powers, 1 for the others.
    pub fn scaled(self) -> (Self, Lanes) {
        let is_plain = is_square_for_formulas(self.direction.dot(self.direction));
        let scaled = (self.direction.to_lanes()).map(|v| scaled(v).unwrap_or((v, 1.0)));
        let direction = Vector3x4::new(scaled.map(|(direction, _)| direction));
        let unit = Lanes::new(scaled.map(|(_, unit)| unit));
        let rays = Self {
            direction: self.direction.or(is_plain, direction),
            ..self
        };
        (rays, select(is_plain, Lanes::ONE, unit))
    }

    /// The points `origin + t direction`.
    #[inline]
    pub fn at(&self, t: Lanes) -> Vector3x4 {
        self.origin + self.direction * t
    }
}

/// Up to four hits.
#[derive(Clone, Copy, Debug)]
pub struct PacketHit {
    /// The `t` of the hits: above 0. NaN in lanes without a hit.
    pub t: Lanes,
    /// The shading normals.
    pub normal: Vector3x4,
    /// The geometric normals.
    pub geometric_normal: Vector3x4,
    /// How large the numbers of the shapes are, as lengths along the geometric normals.
    pub scale: Lanes,
}

impl PacketHit {
    /// These four hits.
    #[inline]
    pub fn new(hits: [Hit; 4]) -> Self {
        Self {
            t: Lanes::new(hits.map(|hit| hit.t)),
            normal: Vector3x4::new(hits.map(|hit| hit.normal)),
            geometric_normal: Vector3x4::new(hits.map(|hit| hit.geometric_normal)),
            scale: Lanes::new(hits.map(|hit| hit.scale)),
        }
    }

    /// Hits at these `t`, of these scales, whose shading normals are the geometric ones.
    #[inline]
    pub const fn with_normals(t: Lanes, normal: Vector3x4, scale: Lanes) -> Self {
        Self {
            t,
            normal,
            geometric_normal: normal,
            scale,
        }
    }

    /// The four hits, one by one.
    #[inline]
    pub fn to_hits(self) -> [Hit; 4] {
        let t = self.t.to_array();
        let (normals, faces) = (self.normal.to_lanes(), self.geometric_normal.to_lanes());
        let scale = self.scale.to_array();
        [0, 1, 2, 3].map(|lane| Hit {
            t: t[lane],
            normal: normals[lane],
            geometric_normal: faces[lane],
            scale: scale[lane],
        })
    }

    /// These hits in the lanes of the mask, and `others` in the other lanes.
    #[inline]
    pub fn or(self, mask: Lanes, others: Self) -> Self {
        Self {
            t: select(mask, self.t, others.t),
            normal: self.normal.or(mask, others.normal),
            geometric_normal: self.geometric_normal.or(mask, others.geometric_normal),
            scale: select(mask, self.scale, others.scale),
        }
    }

    /// The greatest distances of the computed hits from their surfaces.
    #[inline]
    pub fn rounding_error(&self, rays: &RayPacket) -> Lanes {
        let largest = rays
            .origin
            .largest_coordinate()
            .fast_max(rays.at(self.t).largest_coordinate())
            .fast_max(self.t)
            // A shape of a student's own may have the scale NaN, which the lesson drops.
            .max(self.scale);
        Lanes::splat(OFFSET) * largest
    }

    /// The hits with their normals turned against the directions of the rays.
    #[inline]
    pub fn facing(self, rays: &RayPacket) -> Self {
        let from_behind = self
            .geometric_normal
            .dot(rays.direction)
            .simd_gt(Lanes::ZERO);
        Self {
            normal: self.normal.negated(from_behind),
            geometric_normal: self.geometric_normal.negated(from_behind),
            ..self
        }
    }
}
