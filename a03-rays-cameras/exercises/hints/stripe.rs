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
        let fraction = 0.5 + 0.5 * ray.direction().y() / self.top;
        let stripe = (fraction * f64::from(self.stripes)) as u32;
        stripe.min(self.stripes - 1)
    }
}
