//! `Hit`: where a ray meets a geometry, and which way the surface faces there.

use a02_math::Normal3;

/// A meeting of a ray and a geometry, which the caller knows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Where on the ray.
    pub t: f64,
    /// The normal of length 1 that light is computed with. On a triangle it is
    /// interpolated between the corners and need not be that of the face.
    pub normal: Normal3,
    /// The normal of length 1 of the surface itself.
    pub face: Normal3,
}

impl Hit {
    /// A meeting with a surface that is lit as it lies.
    #[must_use]
    pub const fn new(t: f64, normal: Normal3) -> Self {
        Self {
            t,
            normal,
            face: normal,
        }
    }
}
