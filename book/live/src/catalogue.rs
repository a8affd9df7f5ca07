//! The pictures of the book that its pages can render, by the names of their files.

use a03_rays_cameras::TracedScene;
use common::{Error, Scene};
use measure::Stage;

// The pictures of the errata are examples of the last stage.
#[path = "../../../a07-transforms/examples/errata/main.rs"]
#[allow(dead_code, reason = "the example's own main")]
mod errata;
#[path = "../../../a07-transforms/examples/go-wrong/main.rs"]
#[allow(dead_code, reason = "the example's own main")]
pub mod go_wrong;

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

/// The scene whose picture has this name.
pub fn scene(picture: &str) -> Result<Scene, Error> {
    let found = stages().into_iter().find_map(|stage| {
        let mut scenes = stage.scenes.into_iter();
        scenes.find(|scene| name(stage.name, scene) == picture)
    });
    found.ok_or_else(|| Error::Usage(format!("there is no picture \"{picture}\"")))
}

/// The traced scene of a stage whose picture has this name.
pub fn traced_scene(picture: &str) -> Option<TracedScene> {
    let scenes: Vec<TracedScene> = match picture.get(..3)? {
        "a03" => a03_rays_cameras::traced_scenes().into(),
        "a04" => a04_intersections::traced_scenes().into(),
        "a05" => a05_lighting::traced_scenes().into(),
        "a06" => a06_shadows_reflection::traced_scenes().into(),
        "a07" => a07_transforms::traced_scenes().into(),
        _ => return None,
    };
    let stage = stages()
        .into_iter()
        .find(|stage| picture.starts_with(stage.name))?;
    let scene = picture.strip_prefix(stage.name)?.strip_prefix('-')?;
    scenes.into_iter().find(|known| known.name == scene)
}
