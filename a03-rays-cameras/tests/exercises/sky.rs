//! The scene of this stage, with the student's code in it.

pub use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, FRAC_PI_6, PI};

use crate::prelude::*;

/// Compares the scene of curved stripes with its lock.
pub fn scene(
    check: &mut Check,
    render: impl FnOnce(&Settings, View<StripedSky>) -> Result<Image, Error>,
) {
    check.scene(&a03_rays_cameras::stage(), "striped-sky", |settings| {
        let view = scenes::striped_sky(settings.size, StripeRule::Direction)?;
        render(settings, view)
    });
}

/// The direction of a camera's ray through the place (`x`, `y`), for examples.
pub fn direction(camera: &impl Camera, size: Size, x: f64, y: f64) -> [f64; 3] {
    let ray = camera.ray_for(size, x, y);
    ray.direction().to_glam().to_array()
}
