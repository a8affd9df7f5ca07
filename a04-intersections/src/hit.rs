//! `Hit`: an intersection of a ray and a geometry, with the normals there.

use a02_math::Normal3;

/// An intersection of a ray and a geometry. The caller knows both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The parameter of the ray at the hit.
    pub t: f64,
    /// The shading normal, of length 1. On a triangle it is interpolated between
    /// the corners and need not be perpendicular to the face.
    pub normal: Normal3,
    /// The geometric normal: perpendicular to the surface, of length 1.
    pub face: Normal3,
    /// How large the numbers of the shape are from which the hit was computed, as a
    /// length along the geometric normal. Rounding moves the hit off the surface by a few
    /// epsilon of it and of the ray's own numbers. 0 for a shape as large as its rays.
    pub magnitude: f64,
}

impl Hit {
    /// A hit whose shading normal is the geometric normal, of magnitude 0.
    #[must_use]
    pub const fn new(t: f64, normal: Normal3) -> Self {
        Self {
            t,
            normal,
            face: normal,
            magnitude: 0.0,
        }
    }

    /// This hit with a magnitude.
    #[must_use]
    pub const fn with_magnitude(self, magnitude: f64) -> Self {
        Self { magnitude, ..self }
    }
}
