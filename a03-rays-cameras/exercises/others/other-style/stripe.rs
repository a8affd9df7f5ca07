//! `stripe` by the height above the lower edge and that of one stripe, with the edges as cases of their own.

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
        let height = ray.direction().y() + self.top;
        if height <= 0.0 {
            return 0;
        }
        let number = (height / (2.0 * self.top / f64::from(self.stripes))).floor();
        if number >= f64::from(self.stripes) {
            return self.stripes - 1;
        }
        number as u32
    }
}
