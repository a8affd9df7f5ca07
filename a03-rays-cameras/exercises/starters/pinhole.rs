//! `PinholeCamera`: a camera that looks along -z.
//!
//! Chapter: Rays and cameras, section "Pinhole". To compare afterwards:
//! `a03-rays-cameras/src/pinhole_camera.rs`.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{Camera, Ray};
use common::{ArgumentError, Size};

/// A pinhole camera at `origin` that looks along -z with y upwards.
pub struct PinholeCamera {
    origin: Point3,
    /// The full vertical opening angle in radians.
    alpha: f64,
}

impl PinholeCamera {
    pub fn new(origin: Point3, alpha: f64) -> Result<Self, ArgumentError> {
        Ok(Self { origin, alpha })
    }
}

impl Camera for PinholeCamera {
    /// The ray through the position (`x`, `y`) of a picture of this size, with a
    /// direction of length 1. Whole numbers are the middles of pixels and `y` counts
    /// upwards: (0, 0) is the middle of the lower left pixel, so that the lower left
    /// corner of the picture is at (-0.5, -0.5).
    ///
    /// `Ray::derived(origin, direction)` makes a ray, `libm::tan(x)` the tangent.
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let direction = testing::missing("the direction of the ray", Vector3::new(0.0, 0.0, -1.0));
        Ray::derived(self.origin, direction)
    }
}
