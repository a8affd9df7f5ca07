//! `Vector3`: the step from one point to another.

use std::ops::{Add, Div, Mul, Neg, Sub};

use common::{ArgumentError, text};
use glam::DVec3;

use crate::triple::triple;
use crate::{Direction, Normal3};

/// A vector of three coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vector3(DVec3);

triple!(Vector3);

impl Vector3 {
    /// The length, `√(v · v)`, with an error in the last bit or two for lengths
    /// from 1e-150 to 1e150.
    #[must_use]
    pub fn magnitude(self) -> f64 {
        self.0.length()
    }

    // ANCHOR: normalized
    /// The vector of length 1 in the same direction, for any length; `None` for
    /// the zero vector and for coordinates that are not finite.
    #[must_use]
    pub fn normalized(self) -> Option<Self> {
        let squared = self.0.length_squared();
        if (1e-280..=1e280).contains(&squared) {
            return Some(self / squared.sqrt());
        }
        // Outside, the square of the length has lost digits or is infinite.
        let scaled = self.scaled()?;
        Some(scaled / scaled.magnitude())
    }
    // ANCHOR_END: normalized

    /// The vector in the same direction whose largest coordinate is at least 1
    /// and below 2; `None` if there is no direction. The factor is a power of
    /// two, so that nothing is rounded.
    #[must_use]
    pub fn scaled(self) -> Option<Self> {
        let largest = self.0.abs().max_element();
        (self.0.is_finite() && largest > 0.0).then(|| {
            let exponent = libm::ilogb(largest);
            Self(self.0.map(|x| libm::scalbn(x, -exponent)))
        })
    }

    /// The vector of length 1 in the same direction, or an error that names
    /// the argument `name`.
    pub fn unit(self, name: &'static str) -> Result<Self, ArgumentError> {
        self.normalized().ok_or_else(|| {
            ArgumentError::new(
                name,
                format!("[{}]", text::numbers(&self.0.to_array())),
                "a direction: three finite numbers, not all of them 0",
            )
        })
    }

    /// The cross product: perpendicular to both, by the right-hand rule.
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        Self(self.0.cross(other.0))
    }

    /// The same three numbers as a normal.
    #[must_use]
    pub const fn as_normal(self) -> Normal3 {
        Normal3::from_glam(self.0)
    }

    // ANCHOR: reflection
    /// This vector, which points away from a surface, reflected about its normal:
    /// `r = 2 (n · v) n - v`. As long as `v` if `n` has length 1.
    #[must_use]
    pub fn reflected_on(self, n: Normal3) -> Self {
        Self(n.to_glam() * (2.0 * n.dot(self)) - self.0)
    }
    // ANCHOR_END: reflection

    // ANCHOR: angle
    /// The angle to the other vector in radians, from 0 to π.
    ///
    /// The arc tangent of sine and cosine, both scaled by the lengths. Unlike the
    /// arc cosine it resolves the smallest angles, and rounding cannot lead to a
    /// cosine above 1. The angle to the zero vector and to coordinates that are
    /// not finite is 0.
    #[must_use]
    pub fn angle(self, other: Self) -> f64 {
        // The square of the cross product has four lengths as factors, which
        // overflow or underflow. The angle does not depend on the lengths.
        let (Some(a), Some(b)) = (self.scaled(), other.scaled()) else {
            return 0.0;
        };
        libm::atan2(a.cross(b).magnitude(), a.dot(b))
    }
    // ANCHOR_END: angle

    /// The area of the parallelogram spanned by both vectors, `|a × b|`.
    #[must_use]
    pub fn parallelogram_area(self, other: Self) -> f64 {
        self.cross(other).magnitude()
    }

    // ANCHOR: projection
    /// The projection of this vector on the other one, `(a · b / b · b) b`;
    /// `None` if that is the zero vector.
    #[must_use]
    pub fn projected_on(self, other: Self) -> Option<Self> {
        let fraction = self.dot(other) / other.dot(other);
        fraction.is_finite().then(|| other * fraction)
    }
    // ANCHOR_END: projection
}

impl Add for Vector3 {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Add<Normal3> for Vector3 {
    type Output = Self;

    fn add(self, normal: Normal3) -> Self {
        Self(self.0 + normal.to_glam())
    }
}

impl Sub for Vector3 {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Sub<Normal3> for Vector3 {
    type Output = Self;

    fn sub(self, normal: Normal3) -> Self {
        Self(self.0 - normal.to_glam())
    }
}

impl Mul<f64> for Vector3 {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self(self.0 * factor)
    }
}

impl Div<f64> for Vector3 {
    type Output = Self;

    fn div(self, divisor: f64) -> Self {
        Self(self.0 / divisor)
    }
}

impl Neg for Vector3 {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl From<Normal3> for Vector3 {
    fn from(normal: Normal3) -> Self {
        Self(normal.to_glam())
    }
}
