//! `Transform`: a matrix and its inverse, built side by side.
//!
//! Every elementary step has a known inverse. The product of these inverses is
//! more accurate than the inverse of the finished matrix.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::{ArgumentError, argument};

use crate::Mat4x4;

/// Largest magnitude of an entry. Up to here the square of a transformed
/// direction does not overflow.
const MAX_ENTRY: f64 = 1e150;

/// A chain of translations, scalings and rotations.
///
/// A chained call applies to the object before the calls to its left:
/// `Transform::IDENTITY.translate(..)?.rotate_x(..)?` first rotates the object
/// and then translates it. The calls read from the outside inwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    m: Mat4x4,
    i: Mat4x4,
}

impl Transform {
    /// The identity transform.
    pub const IDENTITY: Self = Self {
        m: Mat4x4::IDENTITY,
        i: Mat4x4::IDENTITY,
    };

    /// The matrix from the space of the object to the space around it.
    #[must_use]
    pub const fn matrix(&self) -> Mat4x4 {
        self.m
    }

    /// The matrix from the space around the object to its own space.
    #[must_use]
    pub const fn inverse(&self) -> Mat4x4 {
        self.i
    }

    /// Translates by the coordinates of a point.
    pub fn translate(self, to: Point3) -> Result<Self, ArgumentError> {
        let to = to.checked("translation")?;
        let (x, y, z) = (to.x(), to.y(), to.z());
        let by = |x, y, z| {
            Mat4x4::from_rows([
                [1.0, 0.0, 0.0, x],
                [0.0, 1.0, 0.0, y],
                [0.0, 0.0, 1.0, z],
                [0.0, 0.0, 0.0, 1.0],
            ])
        };
        self.chain(by(x, y, z), by(-x, -y, -z))
    }

    /// Scales along the axes. A negative factor mirrors; the magnitude of each is
    /// from 1e-100 to 1e100, because a factor of 0 has no inverse.
    pub fn scale(self, x: f64, y: f64, z: f64) -> Result<Self, ArgumentError> {
        for (name, factor) in [("scale x", x), ("scale y", y), ("scale z", z)] {
            let valid = argument::length(name, factor.abs()).is_ok();
            let allowed = "a factor whose magnitude is from 1e-100 to 1e100";
            argument::check(name, factor, valid, allowed)?;
        }
        let by = |x, y, z| {
            Mat4x4::from_rows([
                [x, 0.0, 0.0, 0.0],
                [0.0, y, 0.0, 0.0],
                [0.0, 0.0, z, 0.0],
                [0.0, 0.0, 0.0, 1.0],
            ])
        };
        self.chain(by(x, y, z), by(1.0 / x, 1.0 / y, 1.0 / z))
    }

    /// Rotates about the x axis by an angle in radians, from y towards z.
    pub fn rotate_x(self, angle: f64) -> Result<Self, ArgumentError> {
        self.rotate(angle, |sin, cos| {
            [
                [1.0, 0.0, 0.0, 0.0],
                [0.0, cos, -sin, 0.0],
                [0.0, sin, cos, 0.0],
                [0.0, 0.0, 0.0, 1.0],
            ]
        })
    }

    /// Rotates about the y axis by an angle in radians, from z towards x.
    pub fn rotate_y(self, angle: f64) -> Result<Self, ArgumentError> {
        self.rotate(angle, |sin, cos| {
            [
                [cos, 0.0, sin, 0.0],
                [0.0, 1.0, 0.0, 0.0],
                [-sin, 0.0, cos, 0.0],
                [0.0, 0.0, 0.0, 1.0],
            ]
        })
    }

    /// Rotates about the z axis by an angle in radians, from x towards y.
    pub fn rotate_z(self, angle: f64) -> Result<Self, ArgumentError> {
        self.rotate(angle, |sin, cos| {
            [
                [cos, -sin, 0.0, 0.0],
                [sin, cos, 0.0, 0.0],
                [0.0, 0.0, 1.0, 0.0],
                [0.0, 0.0, 0.0, 1.0],
            ]
        })
    }

    /// The inverse of a rotation is its transpose.
    fn rotate(
        self,
        angle: f64,
        rows: impl Fn(f64, f64) -> [[f64; 4]; 4],
    ) -> Result<Self, ArgumentError> {
        let angle = argument::finite("angle", angle)?;
        let rotation = Mat4x4::from_rows(rows(libm::sin(angle), libm::cos(angle)));
        self.chain(rotation, rotation.transposed())
    }

    /// `m' = m T` and, in the opposite order, `i' = T⁻¹ i`: the inverse undoes the
    /// last step first.
    // ANCHOR: chain
    pub(crate) fn chain(self, t: Mat4x4, t_inverse: Mat4x4) -> Result<Self, ArgumentError> {
        let chained = Self {
            m: self.m * t,
            i: t_inverse * self.i,
        };
        if [chained.m, chained.i]
            .iter()
            .all(|m| m.is_within(MAX_ENTRY))
        {
            Ok(chained)
        } else {
            let allowed = "a chain whose matrix and inverse hold no number above 1e150";
            Err(ArgumentError::new("transform", "too large", allowed))
        }
    }
    // ANCHOR_END: chain

    /// The ray in the space of the object: `o' = i o`, `d' = i d`.
    ///
    /// Its direction is not normalised again: so `t` has the same value
    /// in both spaces, and hits can be compared.
    #[must_use]
    // ANCHOR: ray
    pub fn ray_to_object(&self, ray: &Ray) -> Ray {
        Ray::derived(self.i * ray.origin(), self.i * ray.direction())
    }
    // ANCHOR_END: ray

    /// A normal of the object in the space around it: `n' = transpose(i) n`,
    /// normalised.
    ///
    /// Transformed like a vector it would not stay perpendicular to a scaled
    /// object. `None` if the result is 0 or not finite.
    #[must_use]
    // ANCHOR: normal
    pub fn normal_from_object(&self, n: Normal3) -> Option<Normal3> {
        let n = self.i.transposed() * Vector3::from(n);
        n.normalized().map(Vector3::as_normal)
    }
    // ANCHOR_END: normal

    /// The scale of a hit in the space around the object.
    ///
    /// The terms of `i o` and `i p` may be much larger than their sums, and are rounded like
    /// the numbers of the shape. A length along the normal `n` in the space of the object is
    /// `|transpose(i) n|` times as long as around it.
    #[must_use]
    pub fn scale_from_object(&self, hit: &Hit, ray: &Ray) -> f64 {
        let [o, p] = [ray.origin(), ray.at(hit.t)].map(Point3::magnitudes);
        let terms = self.i.magnitudes() * (o + (p - Point3::ORIGIN)) - Point3::ORIGIN;
        let n = self.i.transposed() * Vector3::from(hit.geometric_normal);
        (terms.dot_of_magnitudes(hit.geometric_normal) + hit.scale) / n.magnitude()
    }
}
