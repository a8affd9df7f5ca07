//! `stripe` as the number of borders that lie below the ray.

use crate::prelude::*;

pub struct Sky {
    stripes: u32,
    top: f64,
}

impl Sky {
    pub fn new(camera: &PinholeCamera, size: Size, stripes: u32) -> Result<Self, ArgumentError> {
        let upper_edge = camera.generate_ray(size, f64::from(size.width()) / 2.0, 0.0);
        Ok(Self {
            stripes,
            top: upper_edge.direction().y(),
        })
    }

    pub fn stripe(&self, ray: &Ray) -> u32 {
        let y = ray.direction().y();
        let border = |k: u32| f64::from(2 * k) / f64::from(self.stripes) - 1.0;
        (1..self.stripes)
            .filter(|k| y >= self.top * border(*k))
            .count() as u32
    }
}
