//! `PinholeCamera`: the second course's camera, which looks along -z.

use a02_math::{Point3, Vector3};
use common::{ArgumentError, Size};

use crate::camera::FieldOfView;
use crate::{Camera, Ray};

/// A pinhole camera at `origin` that looks along -z with y upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PinholeCamera {
    pub(crate) origin: Point3,
    pub(crate) field_of_view: FieldOfView,
}

impl PinholeCamera {
    /// A camera with the full vertical field of view `alpha` in radians: above 0
    /// and below π.
    pub fn new(origin: Point3, alpha: f64) -> Result<Self, ArgumentError> {
        Ok(Self {
            origin: origin.checked("origin")?,
            field_of_view: FieldOfView::new(alpha)?,
        })
    }

    /// The ray through the position (`x`, `y`) of the picture, both finite and
    /// counted from its upper left corner, `y` downwards. By the formula of
    /// the second text its direction is `(x - w/2, h/2 - y, -(h/2) / tan(alpha/2))`.
    #[must_use]
    pub fn generate_ray(&self, size: Size, x: f64, y: f64) -> Ray {
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let z = -self.field_of_view.distance(height);
        let direction = Vector3::new(x - width / 2.0, height / 2.0 - y, z);
        // With finite x and y there is always a direction to normalise.
        let gaze = Vector3::new(0.0, 0.0, -1.0);
        Ray::derived(self.origin, direction.normalized().unwrap_or(gaze))
    }
}

/// Converts coordinates: the middle of the lower left pixel is (0, 0) for
/// [`Camera`] and (0.5, h - 0.5) for the pinhole camera.
impl Camera for PinholeCamera {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        self.generate_ray(size, x + 0.5, f64::from(size.height()) - 0.5 - y)
    }
}
