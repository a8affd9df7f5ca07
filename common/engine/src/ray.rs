//! `Ray` and `Hit`: a ray, and its hit on a surface.

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

/// A point at which a ray meets a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The position on the ray.
    pub t: f64,
    /// The shading normal, of length 1. On a triangle it is interpolated between
    /// the corners.
    pub normal: DVec3,
    /// The geometric normal, of length 1.
    pub geometric_normal: DVec3,
    /// The largest term of the shape's own numbers in the computation of `t`, as a length along
    /// the geometric normal: rounding moves the hit off the surface by a few epsilon times it.
    pub scale: f64,
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
            geometric_normal: normal,
            scale: 0.0,
        }
    }
}
