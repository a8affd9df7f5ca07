//! `OrthographicCamera` by the steps from pixel to pixel.

use crate::prelude::*;

pub struct OrthographicCamera {
    basis: Basis,
    s: f64,
}

impl OrthographicCamera {
    pub fn new(e: Point3, g: Vector3, t: Vector3, s: f64) -> Result<Self, ArgumentError> {
        Ok(Self {
            basis: Basis::new(e, g, t)?,
            s,
        })
    }
}

impl Camera for OrthographicCamera {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let Basis { e, u, v, w } = self.basis;
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let aspect = width / height;
        let across = self.s * aspect / (width - 1.0).max(1.0);
        let upwards = self.s / (height - 1.0).max(1.0);
        let middle = [(width - 1.0) / 2.0, (height - 1.0) / 2.0];
        let origin = e + u * ((x - middle[0]) * across) + v * ((y - middle[1]) * upwards);
        Ray::derived(origin, -w)
    }
}
