//! The scene of this stage, with the student's code in it.

use crate::prelude::*;

/// Compares the scene of curved stripes with its lock.
pub fn scene(
    check: &mut Check,
    render: impl FnOnce(&Settings, View<StripedSky>) -> Result<Image, Error>,
) {
    check.scene(&a03_rays_cameras::stage(), "striped-sky", |settings| {
        render(
            settings,
            scenes::striped_sky(settings.size, StripeRule::Direction)?,
        )
    });
}

pub fn point(xyz: [f64; 3]) -> Point3 {
    Point3::from_glam(xyz.into())
}

pub fn vector(xyz: [f64; 3]) -> Vector3 {
    Vector3::from_glam(xyz.into())
}
