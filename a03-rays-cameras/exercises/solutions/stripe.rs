//! `Sky`: the lesson's sky, with the rule of the text.

use crate::prelude::*;

pub struct Sky(StripedSky);

impl Sky {
    pub fn new(camera: &PinholeCamera, size: Size, stripes: u32) -> Result<Self, ArgumentError> {
        StripedSky::new(camera, size, stripes, StripeRule::Direction).map(Self)
    }

    pub fn stripe(&self, ray: &Ray) -> u32 {
        self.0.stripe(ray)
    }
}
