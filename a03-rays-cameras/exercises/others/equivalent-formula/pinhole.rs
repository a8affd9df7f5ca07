//! `PinholeCamera` at the distance 1 from its picture, in which places are from -1 to 1.

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
        let top = libm::tan(self.alpha / 2.0);
        let across = (2.0 * x + 1.0) / width - 1.0;
        let upwards = (2.0 * y + 1.0) / height - 1.0;
        let direction = Vector3::new(across * top * width / height, upwards * top, -1.0);
        Ray::derived(self.origin, direction.normalized().unwrap_or_default())
    }
}
