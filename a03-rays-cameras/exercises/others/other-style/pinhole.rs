//! `PinholeCamera` by sine and cosine of half the angle, without a tangent, divided by the length at the end.

use crate::prelude::*;

pub struct PinholeCamera {
    origin: Point3,
    alpha: f64,
}

impl PinholeCamera {
    pub fn new(origin: Point3, alpha: f64) -> Result<Self, ArgumentError> {
        Ok(Self { origin, alpha })
    }
}

impl Camera for PinholeCamera {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let (sin, cos) = libm::sincos(self.alpha / 2.0);
        let right = (2.0 * x - width + 1.0) * sin;
        let up = (2.0 * y - height + 1.0) * sin;
        let ahead = height * cos;
        let length = (right * right + up * up + ahead * ahead).sqrt();
        let direction = Vector3::new(right / length, up / length, -ahead / length);
        Ray::derived(self.origin, direction)
    }
}
