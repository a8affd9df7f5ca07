//! `Camera`: turns a position in the picture into a ray. Also the basis that two
//! of the cameras share.

use std::any::Any;

use a02_math::{Point3, Vector3};
use common::{ArgumentError, Size, argument, text};

use crate::Ray;

/// Computes a ray for every position in a picture.
pub trait Camera: Any + Send + Sync {
    /// The ray through the position (`x`, `y`) of a picture of this size, both
    /// finite. As in the course, whole numbers are the middles of pixels and
    /// `y` counts upwards: (0, 0) is the middle of the lower left pixel.
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray;
}

impl<C: Camera + ?Sized> Camera for Box<C> {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        (**self).ray_for(size, x, y)
    }
}

/// Position and orientation of a camera: an eye and three axes of length 1,
/// perpendicular to each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Basis {
    /// The eye: the position of the camera.
    pub e: Point3,
    /// The direction to the right in the picture.
    pub u: Vector3,
    /// The direction upwards in the picture.
    pub v: Vector3,
    /// The direction opposite to the gaze.
    pub w: Vector3,
}

impl Basis {
    // ANCHOR: basis
    /// The basis of a camera at `e` that looks along the gaze direction `g`,
    /// with the up vector `t` upwards in its picture:
    /// `w = -g / |g|`, `u = (t × w) / |t × w|`, `v = w × u`.
    ///
    /// An error if `g` or `t` is no direction, or if they are parallel up to
    /// rounding, because they then leave the orientation undetermined.
    pub fn new(e: Point3, g: Vector3, t: Vector3) -> Result<Self, ArgumentError> {
        let e = e.checked("eye point")?;
        let w = -g.unit("gaze direction")?;
        let t = t.unit("up vector")?;
        let right = t.cross(w);
        if right.magnitude() < 1e-12 {
            let allowed = "a direction that is not parallel to the gaze";
            let given = format!("[{}]", text::numbers(&t.to_glam().to_array()));
            return Err(ArgumentError::new("up vector", given, allowed));
        }
        let u = right.unit("up vector")?;
        Ok(Self {
            e,
            u,
            v: w.cross(u),
            w,
        })
    }
    // ANCHOR_END: basis

    /// The direction `x u + y v - z w`, normalised; `z` is positive.
    pub(crate) fn direction(&self, x: f64, y: f64, z: f64) -> Vector3 {
        let direction = self.u * x + self.v * y - self.w * z;
        // With finite x and y there is always a direction to normalise.
        direction.normalized().unwrap_or(-self.w)
    }
}

/// The field of view of a camera: the tangent of half the vertical field of view,
/// which is half the height of a picture at distance 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FieldOfView {
    pub half_tangent: f64,
}

impl FieldOfView {
    /// From the full vertical field of view in radians: above 0 and below π.
    pub fn new(angle: f64) -> Result<Self, ArgumentError> {
        // Below 1e-100 the picture's distance would exceed the limit of lengths.
        let valid = (1e-100..std::f64::consts::PI).contains(&angle);
        let allowed = "the full field of view in radians: from 1e-100 to less than pi";
        argument::check("angle", angle, valid, allowed)?;
        Ok(Self {
            half_tangent: libm::tan(angle / 2.0),
        })
    }

    /// The distance from the eye, in pixels, at which a picture of this height
    /// fills the field of view: `(h / 2) / tan(angle / 2)`.
    pub fn distance(self, height: f64) -> f64 {
        (height / 2.0) / self.half_tangent
    }
}
