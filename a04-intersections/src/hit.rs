//! `Hit`: an intersection of a ray and a geometry, with the normals there.

use a02_math::Normal3;

/// An intersection of a ray and a geometry. The caller knows both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The parameter of the ray at the hit.
    pub t: f64,
    /// The shading normal, of length 1. On a triangle it is interpolated between
    /// the corners and need not be perpendicular to the surface.
    pub normal: Normal3,
    /// The geometric normal: perpendicular to the surface, of length 1.
    pub geometric_normal: Normal3,
    /// The largest term of the shape's own numbers in the computation of `t`, as a length
    /// along the geometric normal. Rounding moves the hit off the surface by a few epsilon
    /// times this term and the ray's own numbers. 0 where no term is larger than those
    /// of the ray.
    pub scale: f64,
}

impl Hit {
    /// A hit whose shading normal is the geometric normal, of scale 0.
    #[must_use]
    pub const fn new(t: f64, normal: Normal3) -> Self {
        Self {
            t,
            normal,
            geometric_normal: normal,
            scale: 0.0,
        }
    }

    /// This hit with a scale.
    #[must_use]
    pub const fn with_scale(self, scale: f64) -> Self {
        Self { scale, ..self }
    }
}
