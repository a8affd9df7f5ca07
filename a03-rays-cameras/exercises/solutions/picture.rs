//! `picture`: the lesson's own `render`.

use crate::prelude::*;

pub fn picture(
    camera: &dyn Camera,
    radiance: &(dyn Fn(&Ray) -> Color + Sync),
    settings: &Settings,
) -> Result<Image, Error> {
    render(camera, radiance, settings, &())
}
