//! `OrthographicCamera`: parallel rays, so that size does not depend on distance.

use crate::prelude::*;

/// A camera whose rays are parallel.
pub struct OrthographicCamera {
    basis: Basis,
    s: f64,
}

impl OrthographicCamera {
    /// A camera at `e` looking along `g` with `t` upwards, whose picture of `w` by `h`
    /// pixels shows a height of `s` from the middle of its lowest pixel to the middle of its highest, and a width of
    /// `s w / h` from the middle of its first column to the middle of its last.
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
        // 1. Find the offset from the middle, as fractions of the picture's width and height.
        // 2. Scale both fractions to lengths; the picture may be wider than high.
        // 3. Move the eye by these lengths along u and v, and look along the gaze.
        missing!("the ray", Ray::derived(e, w), {
            let across = (x - (width - 1.0) / 2.0) / (width - 1.0).max(1.0);
            let upwards = (y - (height - 1.0) / 2.0) / (height - 1.0).max(1.0);
            let right = width / height * self.s * across;
            let up = self.s * upwards;
            Ray::derived(e + u * right + v * up, -w)
        })
    }
}

testing::examples! {
    let [g, t] = [Vector3::new(0.0, 0.0, -1.0), Vector3::new(0.0, 1.0, 0.0)];
    let camera = OrthographicCamera::new(Point3::ORIGIN, g, t, 6.0).unwrap();
    let ray = |x, y| camera.ray_for(Size::new(5, 3).unwrap(), x, y);
    assert_close!(array(ray(2.0, 1.0).origin()), [0.0; 3], "through the middle");
    assert_close!(ray(2.0, 2.0).origin().y(), 3.0);
    assert_close!(ray(4.0, 1.0).origin().x(), 5.0);
    assert_close!(array(ray(4.0, 2.0).direction()), array(g), "through a corner");
}
