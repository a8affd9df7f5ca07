//! `Sky`: horizontal stripes.

use crate::prelude::*;

/// A sky of stripes of equal height, which fill the picture of a camera.
pub struct Sky {
    stripes: u32,
    /// Height of the direction, of length 1, at the upper edge of the picture. At the
    /// lower edge it is `-top`.
    top: f64,
}

impl Sky {
    pub fn new(camera: &PinholeCamera, size: Size, stripes: u32) -> Result<Self, ArgumentError> {
        let upper_edge = camera.generate_ray(size, f64::from(size.width()) / 2.0, 0.0);
        let top = upper_edge.direction().y();
        Ok(Self { stripes, top })
    }

    /// Number of the stripe that the ray hits, counted from 0 at the lower edge, by the height
    /// `ray.direction().y()`. Rays beyond an edge hit the stripe at that edge.
    pub fn stripe(&self, ray: &Ray) -> u32 {
        // 1. Map the height to a fraction: 0 at the lower edge, 1 at the upper one.
        // 2. Scale the fraction to stripes, and round it down.
        // 3. Move rays beyond an edge into the stripe at that edge.
        missing!("the number of the stripe", 0, {
            let fraction = 0.5 + 0.5 * ray.direction().y() / self.top;
            let stripe = (fraction * f64::from(self.stripes)) as u32;
            stripe.min(self.stripes - 1)
        })
    }
}

testing::examples! {
    let camera = PinholeCamera::new(Point3::ORIGIN, 1.0).unwrap();
    let sky = Sky::new(&camera, Size::COURSE, 10).unwrap();
    let stripe = |y| sky.stripe(&Ray::new(Point3::ORIGIN, Vector3::new(0.0, y, -1.0)).unwrap());
    assert_close!(stripe(0.01), 5, "just above the horizon");
    assert_close!(stripe(-0.01), 4, "just below it");
    assert_close!(stripe(9.0), 9, "above the picture");
    assert_close!(stripe(-9.0), 0, "below the picture");
}
