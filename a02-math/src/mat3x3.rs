//! `Mat3x3`: nine numbers that map vectors and points.

use std::ops::Mul;

use glam::DMat3;

use crate::{Point3, Vector3};

/// A matrix of three rows and three columns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mat3x3(DMat3);

impl Mat3x3 {
    /// The identity matrix.
    pub const IDENTITY: Self = Self(DMat3::IDENTITY);

    /// A matrix, row by row as it is written on paper.
    #[must_use]
    pub fn from_rows(rows: [[f64; 3]; 3]) -> Self {
        // glam stores matrices by columns.
        Self(DMat3::from_cols_array_2d(&rows).transpose())
    }

    /// The determinant: the signed volume that the columns span.
    #[must_use]
    pub fn determinant(self) -> f64 {
        self.0.determinant()
    }

    /// This matrix with its first column replaced.
    #[must_use]
    pub const fn change_col_1(mut self, column: Vector3) -> Self {
        self.0.x_axis = column.to_glam();
        self
    }

    /// This matrix with its second column replaced.
    #[must_use]
    pub const fn change_col_2(mut self, column: Vector3) -> Self {
        self.0.y_axis = column.to_glam();
        self
    }

    /// This matrix with its third column replaced.
    #[must_use]
    pub const fn change_col_3(mut self, column: Vector3) -> Self {
        self.0.z_axis = column.to_glam();
        self
    }
}

impl Mul for Mat3x3 {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Mul<Vector3> for Mat3x3 {
    type Output = Vector3;

    fn mul(self, vector: Vector3) -> Vector3 {
        Vector3::from_glam(self.0 * vector.to_glam())
    }
}

impl Mul<Point3> for Mat3x3 {
    type Output = Point3;

    fn mul(self, point: Point3) -> Point3 {
        Point3::from_glam(self.0 * point.to_glam())
    }
}
