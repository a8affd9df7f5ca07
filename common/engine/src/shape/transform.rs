//! `Transform`: a matrix and its inverse, applied to rays and normals: one, or four side by
//! side.

use glam::{DMat4, DVec3};

use crate::Ray;
use crate::lanes::{Lanes, RayPacket, Vector3x4};
use crate::vector::normalized;

/// A matrix and its inverse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// From the space of the object to the space around it.
    pub matrix: DMat4,
    /// From the space around the object to its own.
    pub inverse: DMat4,
}

/// Largest product of the magnitudes of matrix and inverse for which rounding leaves most
/// of a transformed normal.
const WORST_CONDITION: f64 = 1_048_576.0;

/// Largest entry of an inverse, and the reciprocal of the largest entry of a matrix, so that
/// the length of a transformed normal can be squared.
const LARGEST_ENTRY: f64 = 1e100;

impl Transform {
    /// The ray in the space of the object. Its direction keeps the length that the
    /// inverse gives it, so that `t` means the same in both spaces.
    pub(crate) fn ray(&self, ray: &Ray) -> Ray {
        Ray {
            origin: self.inverse.transform_point3(ray.origin),
            direction: self.inverse.transform_vector3(ray.direction),
        }
    }

    /// A normal in the space around the object, of length 1; none if rounding leaves
    /// nothing of it.
    pub(crate) fn normal(&self, n: DVec3) -> Option<DVec3> {
        normalized(self.inverse.transpose().transform_vector3(n))
    }

    /// Four rays in the space of the object.
    #[inline]
    pub(super) fn rays(&self, rays: &RayPacket) -> RayPacket {
        let [x, y, z, w] = self.columns().map(Vector3x4::splat);
        let moved = |v: Vector3x4| x * v.x + y * v.y + z * v.z;
        RayPacket {
            origin: moved(rays.origin) + w,
            direction: moved(rays.direction),
        }
    }

    /// Four normals in the space around the object, and a mask of those of length 1.
    #[inline]
    pub(super) fn normals(&self, n: Vector3x4) -> (Vector3x4, Lanes) {
        let [x, y, z, _] = self.columns().map(|column| Vector3x4::splat(column).dot(n));
        Vector3x4 { x, y, z }.normalized()
    }

    /// The columns of the inverse.
    #[inline]
    fn columns(&self) -> [DVec3; 4] {
        let i = &self.inverse;
        [i.x_axis, i.y_axis, i.z_axis, i.w_axis].map(glam::DVec4::truncate)
    }

    /// Whether every normal of length 1 can be brought to length 1 again.
    ///
    /// With `e = i m - 1` the transformed normal `n' = iᵀ n` has `|mᵀ n'| ≥ 1 - |e|`, so
    /// that its length is at least `(1 - |e|) / |m|`. Rounding takes less than `4 eps |i|`
    /// of it.
    pub(super) fn keeps_normals(&self) -> bool {
        let (size, of_inverse) = (norm(self.matrix), norm(self.inverse));
        norm(self.inverse * self.matrix - DMat4::IDENTITY) < 0.5
            && size * of_inverse < WORST_CONDITION
            && size.max(of_inverse) < LARGEST_ENTRY
    }
}

/// The Frobenius norm of the upper left three by three numbers: no vector is made longer
/// than by this factor.
pub(super) fn norm(matrix: DMat4) -> f64 {
    let columns = [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(glam::DVec4::truncate);
    columns
        .map(DVec3::length_squared)
        .iter()
        .sum::<f64>()
        .sqrt()
}
