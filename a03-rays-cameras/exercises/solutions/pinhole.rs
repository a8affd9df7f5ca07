//! `PinholeCamera`: a camera that looks along -z.

use crate::prelude::*;

/// A pinhole camera at `origin` that looks along -z with y upwards.
pub struct PinholeCamera {
    origin: Point3,
    /// The full vertical field of view in radians.
    alpha: f64,
}

impl PinholeCamera {
    pub fn new(origin: Point3, alpha: f64) -> Result<Self, ArgumentError> {
        Ok(Self { origin, alpha })
    }
}

impl Camera for PinholeCamera {
    /// The ray through the position (`x`, `y`) of a picture of this size, with a direction of
    /// length 1. (0, 0) is the middle of the lower left pixel, whose corner is (-0.5, -0.5).
    ///
    /// `Ray::derived(origin, direction)` makes a ray, `libm::tan(x)` the tangent;
    /// `vector.normalized()` is `None` for the zero vector.
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let [width, height] = [size.width(), size.height()].map(f64::from);
        // 1. Count the position in pixels from the middle of the picture.
        // 2. Find the distance, in pixels, at which the picture's height fills the field of view.
        // 3. Normalise the vector from the pinhole to the position.
        let direction = missing!("the direction of the ray", Vector3::new(0.0, 0.0, -1.0), {
            let right = x - (width - 1.0) / 2.0;
            let up = y - (height - 1.0) / 2.0;
            let distance = height / 2.0 / libm::tan(self.alpha / 2.0);
            let to_position = Vector3::new(right, up, -distance);
            to_position.normalized().unwrap_or_default()
        });
        Ray::derived(self.origin, direction)
    }
}

testing::examples! {
    let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2).unwrap();
    let direction = |x, y| direction(&camera, Size::new(4, 2).unwrap(), x, y);
    let half = 0.5_f64.sqrt();
    assert_close!(direction(1.5, 0.5), [0.0, 0.0, -1.0]);
    assert_close!(direction(1.5, 1.5), [0.0, half, -half]);
    assert_close!(direction(2.5, 0.5), [half, 0.0, -half]);
}
