//! `OrthographicCamera`: parallel rays, so that size does not depend on distance.

use crate::prelude::*;

/// A camera whose rays are parallel.
pub struct OrthographicCamera {
    basis: Basis,
    s: f64,
}

impl OrthographicCamera {
    /// A camera at `e` looking along `g` with `t` upwards, whose picture shows a height
    /// of `s` from the middle of its lowest pixel to the middle of its highest.
    pub fn new(e: Point3, g: Vector3, t: Vector3, s: f64) -> Result<Self, ArgumentError> {
        let basis = Basis::new(e, g, t)?;
        Ok(Self { basis, s })
    }
}

impl Camera for OrthographicCamera {
    /// The ray through the position (`x`, `y`) of a picture of this size; (0, 0) is the
    /// middle of the lower left pixel.
    ///
    /// The axes of the camera point to the right (`u`), upwards (`v`) and against the gaze
    /// (`w`). `Ray::derived(origin, direction)` makes a ray.
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let Basis { e, u, v, w } = self.basis;
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let across = (x - (width - 1.0) / 2.0) / (width - 1.0).max(1.0);
        let upwards = (y - (height - 1.0) / 2.0) / (height - 1.0).max(1.0);
        let right = width / height * self.s * across;
        let up = self.s * upwards;
        Ray::derived(e + u * right + v * up, -w)
    }
}
