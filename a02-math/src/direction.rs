//! `Direction`: an operand of the dot product.

use glam::DVec3;

use crate::{Normal3, Vector3};

/// A vector or a normal; points have no direction.
pub trait Direction: Copy {
    /// The three numbers of glam.
    fn components(self) -> DVec3;

    /// The dot product: |a| |b| cos of the angle between them.
    #[must_use]
    fn dot(self, other: impl Direction) -> f64 {
        self.components().dot(other.components())
    }

    /// The dot product of the magnitudes of all components: |ax bx| + |ay by| + |az bz|.
    ///
    /// The rounding error of [`dot`](Self::dot) is at most 1.5 epsilon times this (Higham,
    /// Accuracy and Stability of Numerical Algorithms, 2nd edition, section 3.1).
    #[must_use]
    fn dot_of_magnitudes(self, other: impl Direction) -> f64 {
        self.components().abs().dot(other.components().abs())
    }
}

impl Direction for Vector3 {
    fn components(self) -> DVec3 {
        self.to_glam()
    }
}

impl Direction for Normal3 {
    fn components(self) -> DVec3 {
        self.to_glam()
    }
}
