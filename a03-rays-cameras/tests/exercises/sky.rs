//! The scene of this stage, with the student's code in it.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{StripeRule, StripedSky, View, scenes::striped_sky, stage};
use common::{Error, Image, Settings};
use testing::exercise::Check;

/// Compares the scene of curved stripes with its lock.
pub fn scene(
    check: &mut Check,
    render: impl FnOnce(&Settings, View<StripedSky>) -> Result<Image, Error>,
) {
    check.scene(&stage(), "striped-sky", |settings| {
        render(settings, striped_sky(settings.size, StripeRule::Direction)?)
    });
}

pub fn point(xyz: [f64; 3]) -> Point3 {
    Point3::from_glam(xyz.into())
}

pub fn vector(xyz: [f64; 3]) -> Vector3 {
    Vector3::from_glam(xyz.into())
}
