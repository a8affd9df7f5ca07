//! `PerspectiveCamera` at the distance 1 from its picture, whose height is twice the tangent of half the angle.

use crate::prelude::*;

pub struct PerspectiveCamera {
    e: Point3,
    right: Vector3,
    up: Vector3,
    ahead: Vector3,
    height: f64,
}

impl PerspectiveCamera {
    pub fn new(e: Point3, g: Vector3, t: Vector3, angle: f64) -> Result<Self, ArgumentError> {
        let ahead = g.unit("gaze direction")?;
        let right = ahead.cross(t.unit("up vector")?).unit("up vector")?;
        Ok(Self {
            e,
            right,
            up: right.cross(ahead),
            ahead,
            height: 2.0 * libm::tan(angle / 2.0),
        })
    }
}

impl Camera for PerspectiveCamera {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let pixel = self.height / height;
        let right = self.right * (pixel * (x + 0.5 - width / 2.0));
        let up = self.up * (pixel * (y + 0.5 - height / 2.0));
        Ray::derived(
            self.e,
            (self.ahead + right + up).normalized().unwrap_or(self.ahead),
        )
    }
}
