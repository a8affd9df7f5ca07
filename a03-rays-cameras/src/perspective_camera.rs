//! `PerspectiveCamera`: all rays start in the eye, so that far objects look small.

use a02_math::{Point3, Vector3};
use common::{ArgumentError, Size};

use crate::camera::FieldOfView;
use crate::{Basis, Camera, Ray};

/// A camera whose rays start in one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PerspectiveCamera {
    pub(crate) basis: Basis,
    pub(crate) field_of_view: FieldOfView,
}

impl PerspectiveCamera {
    /// A camera at `e` looking along `g` with `t` upwards, with the full vertical
    /// opening `angle` in radians: above 0 and below π.
    pub fn new(e: Point3, g: Vector3, t: Vector3, angle: f64) -> Result<Self, ArgumentError> {
        Ok(Self {
            basis: Basis::new(e, g, t)?,
            field_of_view: FieldOfView::new(angle)?,
        })
    }

    /// Position and orientation of the camera.
    #[must_use]
    pub const fn basis(&self) -> Basis {
        self.basis
    }
}

/// From `e` in the direction
/// `r = -w (h/2) / tan(angle/2) + (x - (w-1)/2) u + (y - (h-1)/2) v`.
impl Camera for PerspectiveCamera {
    // ANCHOR: ray
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let direction = self.basis.direction(
            x - (width - 1.0) / 2.0,
            y - (height - 1.0) / 2.0,
            self.field_of_view.distance(height),
        );
        Ray::derived(self.basis.e, direction)
    }
    // ANCHOR_END: ray
}
