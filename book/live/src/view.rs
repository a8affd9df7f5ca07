//! The views of the traced pictures.

use a02_math::Point3;
use a03_rays_cameras::View;
use common::{ArgumentError, Settings};

use crate::catalogue;

/// The view of a picture; none if the picture is not a traced scene of a stage.
pub fn view(picture: &str, settings: &Settings) -> Result<Option<View>, ArgumentError> {
    let scene = catalogue::traced_scene(picture);
    scene.map(|scene| (scene.view)(settings.size)).transpose()
}

/// The point that the camera of a picture is turned around.
pub fn centre(picture: &str) -> Point3 {
    // The objects that a camera at the origin looks at are three to six before it.
    match picture {
        "a04-intersections-scene-2" | "a04-intersections-scene-4" => Point3::new(0.0, 0.0, -3.0),
        "a04-intersections-scene-5" | "a04-intersections-scene-6" => Point3::new(0.0, 0.0, -4.5),
        _ => Point3::ORIGIN,
    }
}
