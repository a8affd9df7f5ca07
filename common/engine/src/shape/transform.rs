//! `Transform`: a matrix and its inverse, applied to four rays and to four normals.

use fearless_simd::prelude::*;
use glam::{DMat4, DVec3};

use crate::lanes::{Lanes, PacketHit, RayPacket, Vector3x4};

/// A matrix and its inverse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// From the space of the object to the space around it.
    pub matrix: DMat4,
    /// From the space around the object to its own.
    pub inverse: DMat4,
    /// Whether it is applied to rays. The identity need not be: it changes only signs of zeros,
    /// and no formula asks for these. Of hits it rounds the normals and the scale.
    pub(crate) moves_rays: bool,
}

/// Largest product of the magnitudes of matrix and inverse for which rounding leaves most
/// of a transformed normal, and bounds are of use.
pub(super) const WORST_CONDITION: f64 = 1_048_576.0;

/// Largest entry of an inverse, and the reciprocal of the largest entry of a matrix, so that
/// the length of a transformed normal can be squared.
const MAX_ENTRY: f64 = 1e100;

impl Transform {
    pub(super) const IDENTITY: Self = Self::new(DMat4::IDENTITY, DMat4::IDENTITY);

    /// A matrix, from the space of the object to the space around it, and its inverse.
    #[must_use]
    pub const fn new(matrix: DMat4, inverse: DMat4) -> Self {
        Self {
            matrix,
            inverse,
            moves_rays: true,
        }
    }

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
            && size.max(of_inverse) < MAX_ENTRY
    }

    /// By how much it makes lengths longer or shorter, at most.
    #[must_use]
    pub fn scale(&self) -> f64 {
        spectral_norm(self.matrix).max(spectral_norm(self.inverse))
    }

    /// Four rays in the space of the object. Their directions keep the length that the inverse
    /// gives them, so that `t` means the same in both spaces.
    #[inline(always)]
    pub(crate) fn rays<S: Simd>(&self, rays: &RayPacket<S>) -> RayPacket<S> {
        if !self.moves_rays {
            return *rays;
        }
        let [x, y, z, w] = self.columns(rays.simd());
        let RayPacket { origin, direction } = rays;
        RayPacket {
            origin: x * origin.x + y * origin.y + z * origin.z + w,
            direction: x * direction.x + y * direction.y + z * direction.z,
        }
    }

    /// Four normals in the space around the object, of length 1.
    #[inline(always)]
    pub(super) fn normals<S: Simd>(&self, n: Vector3x4<S>) -> Vector3x4<S> {
        self.stretched(n).normalized().0
    }

    /// The scales of four hits of the object in the space around it.
    #[inline(always)]
    pub(super) fn scales<S: Simd>(&self, hit: &PacketHit<S>, rays: &RayPacket<S>) -> Lanes<S> {
        let length = self.stretched(hit.geometric_normal);
        let point = rays.origin.abs() + rays.at(hit.t).abs();
        let [x, y, z, w] = self.columns(rays.simd());
        let terms = x.abs() * point.x + y.abs() * point.y + z.abs() * point.z + w.abs();
        (terms.dot(hit.geometric_normal.abs()) + hit.scale) / length.dot(length).sqrt()
    }

    /// Four normals of the object by the transpose of the inverse, which changes their lengths.
    #[inline(always)]
    fn stretched<S: Simd>(&self, n: Vector3x4<S>) -> Vector3x4<S> {
        let [x, y, z, _] = self.columns(n.x.simd);
        Vector3x4 {
            x: x.dot(n),
            y: y.dot(n),
            z: z.dot(n),
        }
    }

    /// The columns of the inverse, each four times.
    #[inline(always)]
    fn columns<S: Simd>(&self, simd: S) -> [Vector3x4<S>; 4] {
        let i = &self.inverse;
        [
            Vector3x4::splat(simd, i.x_axis.truncate()),
            Vector3x4::splat(simd, i.y_axis.truncate()),
            Vector3x4::splat(simd, i.z_axis.truncate()),
            Vector3x4::splat(simd, i.w_axis.truncate()),
        ]
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
