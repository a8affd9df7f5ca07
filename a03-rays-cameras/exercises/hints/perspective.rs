//! `PerspectiveCamera`: a camera that looks into any direction.

use crate::prelude::*;

/// A camera whose rays start in one point.
pub struct PerspectiveCamera {
    e: Point3,
    /// The unit vectors to the right in the picture, upwards, and against the gaze.
    u: Vector3,
    v: Vector3,
    w: Vector3,
    /// The full vertical field of view in radians.
    angle: f64,
}

impl PerspectiveCamera {
    /// A camera at `e` that looks along `g`, with `t` upwards in its picture. Both have
    /// any length, and need not be perpendicular to each other.
    ///
    /// `vector.unit("its name")?` is the vector of length 1.
    pub fn new(e: Point3, g: Vector3, t: Vector3, angle: f64) -> Result<Self, ArgumentError> {
        let w = -g.unit("gaze direction")?;
        let t = t.unit("up vector")?;
        let u = t.cross(w).unit("up vector")?;
        let v = w.cross(u);
        Ok(Self { e, u, v, w, angle })
    }
}

impl Camera for PerspectiveCamera {
    /// The ray through the position (`x`, `y`) of a picture of this size, with a
    /// direction of length 1. (0, 0) is the middle of the lower left pixel.
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let right = x - (width - 1.0) / 2.0;
        let up = y - (height - 1.0) / 2.0;
        let distance = height / 2.0 / libm::tan(self.angle / 2.0);
        let sum = self.u * right + self.v * up - self.w * distance;
        let direction = sum.normalized().unwrap_or(-self.w);
        Ray::derived(self.e, direction)
    }
}
