//! `OrthographicCamera` by fractions of the width and height; the only pixel of a row is half way.

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
        let fraction = |at: f64, n: f64| if n > 1.0 { at / (n - 1.0) } else { 0.5 };
        let right = self.s * width / height * (fraction(x, width) - 0.5);
        let up = self.s * (fraction(y, height) - 0.5);
        let origin = e + (u * right + v * up);
        Ray::derived(origin, w * -1.0)
    }
}
