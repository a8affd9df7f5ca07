//! `PerspectiveCamera` from the lower left corner of its picture on.

use crate::prelude::*;

pub struct PerspectiveCamera {
    e: Point3,
    basis: Basis,
    angle: f64,
}

impl PerspectiveCamera {
    pub fn new(e: Point3, g: Vector3, t: Vector3, angle: f64) -> Result<Self, ArgumentError> {
        let basis = Basis::new(e, g, t)?;
        Ok(Self { e, basis, angle })
    }
}

impl Camera for PerspectiveCamera {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let Basis { u, v, w, .. } = self.basis;
        let distance = height / (2.0 * libm::tan(self.angle / 2.0));
        let corner = u * (-width / 2.0) + v * (-height / 2.0) - w * distance;
        let direction = corner + u * (x + 0.5) + v * (y + 0.5);
        Ray::derived(self.e, direction.normalized().unwrap_or(-w))
    }
}
