//! `Point3`: a position in space.

use std::ops::{Add, Sub};

use common::{ArgumentError, argument};
use glam::DVec3;

use crate::Vector3;
use crate::triple::triple;

/// A point of three coordinates.
///
/// Two points have a difference, but no sum:
///
/// ```
/// # use a02_math::{Point3, Vector3};
/// let displacement: Vector3 = Point3::new(1.0, 1.0, 1.0) - Point3::new(2.0, 2.0, 0.0);
/// ```
/// ```compile_fail
/// # use a02_math::Point3;
/// let nowhere = Point3::new(1.0, 1.0, 1.0) + Point3::new(2.0, 2.0, 0.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point3(DVec3);

triple!(Point3);

impl Point3 {
    /// The origin of the coordinates.
    pub const ORIGIN: Self = Self(DVec3::ZERO);

    /// This point, if its coordinates are within the range of the formulas, or an
    /// error that names the argument `name`.
    pub fn checked(self, name: &'static str) -> Result<Self, ArgumentError> {
        for coordinate in self.0.to_array() {
            argument::coordinate(name, coordinate)?;
        }
        Ok(self)
    }

    /// The greatest magnitude among the coordinates.
    #[must_use]
    pub fn largest_coordinate(self) -> f64 {
        self.0.abs().max_element()
    }

    /// The point of the magnitudes of all coordinates.
    #[must_use]
    pub fn magnitudes(self) -> Self {
        Self(self.0.abs())
    }
}

// ANCHOR: difference
impl Sub for Point3 {
    type Output = Vector3;

    fn sub(self, other: Self) -> Vector3 {
        Vector3::from_glam(self.0 - other.0)
    }
}
// ANCHOR_END: difference

impl Add<Vector3> for Point3 {
    type Output = Self;

    fn add(self, displacement: Vector3) -> Self {
        Self(self.0 + displacement.to_glam())
    }
}

impl Sub<Vector3> for Point3 {
    type Output = Self;

    fn sub(self, displacement: Vector3) -> Self {
        Self(self.0 - displacement.to_glam())
    }
}
