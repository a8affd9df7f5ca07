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
    /// `vector.unit("its name")?` is the vector of length 1, and `a.cross(b)` the cross product.
    pub fn new(e: Point3, g: Vector3, t: Vector3, angle: f64) -> Result<Self, ArgumentError> {
        // 1. Take w against the gaze.
        // 2. Take u to the right: perpendicular to t and w.
        // 3. Take v upwards: perpendicular to w and u.
        // 4. Normalise w and u; v has length 1 by itself.
        let [u, v, w] = missing!("the three axes of the camera", [Vector3::default(); 3], {
            let w = -g.unit("gaze direction")?;
            let t = t.unit("up vector")?;
            let u = t.cross(w).unit("up vector")?;
            let v = w.cross(u);
            [u, v, w]
        });
        Ok(Self { e, u, v, w, angle })
    }
}

impl Camera for PerspectiveCamera {
    /// The ray through the position (`x`, `y`) of a picture of this size, with a
    /// direction of length 1. (0, 0) is the middle of the lower left pixel.
    ///
    /// `vector * number` scales a vector; `vector.normalized()` is `None` for the zero vector.
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let [width, height] = [size.width(), size.height()].map(f64::from);
        // 1. Count the position in pixels from the middle of the picture.
        // 2. Find the distance, in pixels, at which the picture's height fills the field of view.
        // 3. Combine the three axes, and normalise the sum.
        let direction = missing!("the direction of the ray", self.w, {
            let right = x - (width - 1.0) / 2.0;
            let up = y - (height - 1.0) / 2.0;
            let distance = height / 2.0 / libm::tan(self.angle / 2.0);
            let sum = self.u * right + self.v * up - self.w * distance;
            sum.normalized().unwrap_or(-self.w)
        });
        Ray::derived(self.e, direction)
    }
}

testing::examples! {
    let [gaze, up] = [Vector3::new(0.0, 0.0, -2.0), Vector3::new(0.0, 3.0, 1.0)];
    let camera = PerspectiveCamera::new(Point3::ORIGIN, gaze, up, FRAC_PI_2).unwrap();
    let direction = |x, y| direction(&camera, Size::new(4, 2).unwrap(), x, y);
    let half = 0.5_f64.sqrt();
    assert_close!(direction(1.5, 0.5), [0.0, 0.0, -1.0]);
    assert_close!(direction(1.5, 1.5), [0.0, half, -half]);
    assert_close!(direction(2.5, 0.5), [half, 0.0, -half]);
}
