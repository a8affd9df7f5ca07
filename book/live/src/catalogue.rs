//! The pictures of the book that its pages can render, by the names of their files.

use a02_math::Point3;
use a03_rays_cameras::{View, Views};
use a07_lab::{errata, go_wrong};
use common::{Error, Scene, Settings, Stage};

use crate::file;

/// The name of the picture of a scene file begins with it; the text of the file follows.
pub const FILE: &str = "file\n";

/// The stages, and two more: the pictures of the errata, and of mistakes that `go-wrong` shows.
pub fn stages() -> [Stage; 9] {
    [
        a01_image_display::stage(),
        a02_math::stage(),
        a03_rays_cameras::stage(),
        a04_intersections::stage(),
        a05_lighting::stage(),
        a06_shadows_reflection::stage(),
        a07_transforms::stage(),
        errata::stage(),
        go_wrong::stage(),
    ]
}

fn name(stage: &str, scene: &Scene) -> String {
    format!("{stage}-{}", scene.name)
}

/// The names of all pictures.
pub fn names() -> Vec<String> {
    let stages = stages();
    let names = stages
        .iter()
        .flat_map(|stage| stage.scenes.iter().map(|scene| name(stage.name, scene)));
    names.collect()
}

/// The scene whose picture has this name, or of the file with this text.
pub fn scene(picture: &str) -> Result<Scene, Error> {
    if let Some(text) = picture.strip_prefix(FILE) {
        return file::scene(text);
    }
    let found = stages().into_iter().find_map(|stage| {
        let mut scenes = stage.scenes.into_iter();
        scenes.find(|scene| name(stage.name, scene) == picture)
    });
    found.ok_or_else(|| Error::Usage(format!("there is no picture \"{picture}\"")))
}

/// The view of a picture; none if the picture is painted.
pub fn view(picture: &str, settings: &Settings) -> Result<Option<View>, Error> {
    let scene = scene(picture)?;
    let views = Views::of(&scene).ok();
    views.map(|views| views.view(settings)).transpose()
}

/// The point that the camera of a picture is rotated around.
pub fn centre(picture: &str) -> Point3 {
    // The objects that a camera at the origin looks at are three to six before it.
    match picture {
        "a04-intersections-scene-2" | "a04-intersections-scene-4" => Point3::new(0.0, 0.0, -3.0),
        "a04-intersections-scene-5" | "a04-intersections-scene-6" => Point3::new(0.0, 0.0, -4.5),
        _ => Point3::ORIGIN,
    }
}
