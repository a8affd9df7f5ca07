//! `Mat4x4`: sixteen numbers that rotate, scale and translate.

use std::ops::Mul;

use a02_math::{Point3, Vector3};
use glam::DMat4;

/// A matrix of four rows and four columns.
///
/// The fourth coordinate of a point is 1 and of a vector 0: the last column
/// translates points, and does not change vectors. The last row is (0, 0, 0, 1)
/// in every translation, scaling and rotation, and is not applied.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mat4x4(DMat4);

impl Mat4x4 {
    /// The identity matrix.
    pub const IDENTITY: Self = Self(DMat4::IDENTITY);

    /// A matrix, row by row as it is written on paper.
    #[must_use]
    pub fn from_rows(rows: [[f64; 4]; 4]) -> Self {
        // glam stores matrices by columns.
        Self(DMat4::from_cols_array_2d(&rows).transpose())
    }

    /// The entries, row by row.
    #[must_use]
    pub fn rows(self) -> [[f64; 4]; 4] {
        self.0.transpose().to_cols_array_2d()
    }

    /// As sixteen numbers of glam.
    #[must_use]
    pub const fn to_glam(self) -> DMat4 {
        self.0
    }

    /// The transposed matrix.
    #[must_use]
    pub fn transposed(self) -> Self {
        Self(self.0.transpose())
    }

    /// The matrix of the magnitudes of all entries.
    #[must_use]
    pub fn magnitudes(self) -> Self {
        Self(self.0.abs())
    }

    /// Whether the magnitude of every entry is at most `limit`; false for NaN.
    #[must_use]
    pub fn is_within(self, limit: f64) -> bool {
        self.0
            .to_cols_array()
            .iter()
            .all(|entry| entry.abs() <= limit)
    }
}

impl Mul for Mat4x4 {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Mul<Vector3> for Mat4x4 {
    type Output = Vector3;

    fn mul(self, vector: Vector3) -> Vector3 {
        Vector3::from_glam(self.0.transform_vector3(vector.to_glam()))
    }
}

impl Mul<Point3> for Mat4x4 {
    type Output = Point3;

    fn mul(self, point: Point3) -> Point3 {
        Point3::from_glam(self.0.transform_point3(point.to_glam()))
    }
}
