//! `Transform`: a matrix and its inverse, applied to four rays and to four normals.

use glam::{DMat4, DVec3};

use crate::lanes::{Lanes, PacketHit, RayPacket, Vector3x4};

/// A matrix and its inverse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// From the space of the object to the space around it.
    pub matrix: DMat4,
    /// From the space around the object to its own.
    pub inverse: DMat4,
}

/// Largest product of the magnitudes of matrix and inverse for which rounding leaves most
/// of a transformed normal, and bounds are of use.
pub(super) const WORST_CONDITION: f64 = 1_048_576.0;

/// Largest entry of an inverse, and the reciprocal of the largest entry of a matrix, so that
/// the length of a transformed normal can be squared.
const LARGEST_ENTRY: f64 = 1e100;

impl Transform {
    /// Whether rounding keeps every transformed normal: a shape under another transform has to
    /// be handed over as a function.
    ///
    /// With `e = i m - 1` the transformed normal `n' = iᵀ n` has `|mᵀ n'| ≥ 1 - |e|`, so
    /// that its length is at least `(1 - |e|) / |m|`. Rounding takes less than `4 eps |i|`
    /// of it.
    #[must_use]
    pub fn is_well_conditioned(&self) -> bool {
        let (size, of_inverse) = (norm(self.matrix), norm(self.inverse));
        norm(self.inverse * self.matrix - DMat4::IDENTITY) < 0.5
            && size * of_inverse < WORST_CONDITION
            && size.max(of_inverse) < LARGEST_ENTRY
    }

    /// By how much it makes lengths longer or shorter, at most.
    #[must_use]
    pub fn scale(&self) -> f64 {
        spectral_norm(self.matrix).max(spectral_norm(self.inverse))
    }

    /// Four rays in the space of the object. Their directions keep the length that the inverse
    /// gives them, so that `t` means the same in both spaces.
    #[inline]
    pub(crate) fn rays(&self, rays: &RayPacket) -> RayPacket {
        let [x, y, z, w] = self.columns().map(Vector3x4::splat);
        let moved = |v: Vector3x4| x * v.x + y * v.y + z * v.z;
        RayPacket {
            origin: moved(rays.origin) + w,
            direction: moved(rays.direction),
        }
    }

    /// Four normals in the space around the object, of length 1.
    #[inline]
    pub(super) fn normals(&self, n: Vector3x4) -> Vector3x4 {
        let [x, y, z, _] = self.columns().map(|column| Vector3x4::splat(column).dot(n));
        Vector3x4 { x, y, z }.normalized().0
    }

    /// The scales of four hits of the object in the space around it.
    #[inline]
    pub(super) fn scales(&self, hit: &PacketHit, rays: &RayPacket) -> Lanes {
        let columns = self.columns().map(Vector3x4::splat);
        let [x, y, z] =
            [columns[0], columns[1], columns[2]].map(|column| column.dot(hit.geometric_normal));
        let length = Vector3x4 { x, y, z };
        let point = rays.origin.abs() + rays.at(hit.t).abs();
        let [x, y, z, w] = columns.map(Vector3x4::abs);
        let terms = x * point.x + y * point.y + z * point.z + w;
        (terms.dot(hit.geometric_normal.abs()) + hit.scale) / length.dot(length).sqrt()
    }

    /// The columns of the inverse.
    #[inline]
    fn columns(&self) -> [DVec3; 4] {
        let i = &self.inverse;
        [i.x_axis, i.y_axis, i.z_axis, i.w_axis].map(glam::DVec4::truncate)
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

/// At least the spectral norm of the upper left three by three numbers `a`, and equal to
/// it if they turn, and stretch evenly: |a|² = |aᵀ a|, and no norm is above the largest
/// sum of a row's magnitudes.
pub(super) fn spectral_norm(matrix: DMat4) -> f64 {
    let columns = [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(glam::DVec4::truncate);
    let sum = |a: DVec3| columns.iter().map(|b| a.dot(*b).abs()).sum::<f64>();
    columns.map(sum).into_iter().fold(0.0, f64::max).sqrt()
}
