//! `Normal3`: the direction that a surface faces.

use std::ops::{Add, Mul, Neg};

use common::ArgumentError;
use glam::DVec3;

use crate::Vector3;
use crate::triple::triple;

/// A normal of three coordinates. Normals of surfaces have length 1; sums and
/// multiples need not.
///
/// A type of its own because transforms treat normals differently from vectors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Normal3(DVec3);

triple!(Normal3);

impl Normal3 {
    /// The normal of length 1 in the same direction; `None` for the zero normal
    /// and for coordinates that are not finite.
    #[must_use]
    pub fn normalized(self) -> Option<Self> {
        Vector3::from(self).normalized().map(Vector3::as_normal)
    }

    /// The normal of length 1 in the same direction, or an error that names
    /// the argument `name`.
    pub fn unit(self, name: &'static str) -> Result<Self, ArgumentError> {
        Vector3::from(self).unit(name).map(Vector3::as_normal)
    }
}

impl Add for Normal3 {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Mul<f64> for Normal3 {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self(self.0 * factor)
    }
}

impl Neg for Normal3 {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}
