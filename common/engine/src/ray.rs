//! `Ray`, `Interval` and `Hit`: a ray, the part of it in which hits count, and a hit on
//! a surface.

use glam::DVec3;

/// A ray: the points `origin + t direction`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// The start of the ray.
    pub origin: DVec3,
    /// The direction of the ray. Its length is 1 except in the space of a transformed
    /// shape.
    pub direction: DVec3,
}

impl Ray {
    /// The point `origin + t direction`.
    #[inline]
    #[must_use]
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + self.direction * t
    }
}

/// An open interval of `t`: its ends do not belong to it, and NaN belongs to none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Lower end, at least 0.
    pub min: f64,
    /// Upper end; may be infinite.
    pub max: f64,
}

impl Interval {
    /// The whole ray without its origin.
    pub const AHEAD: Self = Self::before(f64::INFINITY);

    /// The part of the ray before `max`.
    #[must_use]
    pub const fn before(max: f64) -> Self {
        Self { min: 0.0, max }
    }

    /// Whether `t` lies inside.
    #[inline]
    #[must_use]
    pub fn contains(self, t: f64) -> bool {
        self.min < t && t < self.max
    }
}

/// A point at which a ray meets a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The place on the ray.
    pub t: f64,
    /// The shading normal, of length 1. On a triangle it is interpolated between
    /// the corners.
    pub normal: DVec3,
    /// The geometric normal, of length 1.
    pub face: DVec3,
}

impl Hit {
    /// No hit: `t` is NaN.
    pub(crate) const NONE: Self = Self::new(f64::NAN, DVec3::ZERO);

    /// A hit whose shading normal is the geometric one.
    #[must_use]
    pub const fn new(t: f64, normal: DVec3) -> Self {
        Self {
            t,
            normal,
            face: normal,
        }
    }

    /// The hit with its normals turned against the direction `d`.
    pub(crate) fn facing(self, d: DVec3) -> Self {
        if self.face.dot(d) > 0.0 {
            Self {
                normal: -self.normal,
                face: -self.face,
                ..self
            }
        } else {
            self
        }
    }
}
