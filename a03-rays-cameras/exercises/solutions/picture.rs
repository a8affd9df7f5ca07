//! `picture`: the lesson's own `render`.

use a03_rays_cameras::{Camera, Ray, render};
use common::{Color, Error, Image, Settings};

pub fn picture(
    camera: &dyn Camera,
    radiance: &(dyn Fn(&Ray) -> Color + Sync),
    settings: &Settings,
) -> Result<Image, Error> {
    render(camera, radiance, settings, &())
}
