//! Scenes of the text that a reader writes on the page, as a scene file of the last stage.

use std::sync::Arc;

use a03_rays_cameras::kinds::NumberedFile;
use a03_rays_cameras::{TracedScene, View};
use a07_transforms::kinds::FORMAT;
use a07_transforms::kinds::example_files::PYRAMID;
use common::{Error, Renderer, Scene, Settings};
use scene_file::Mesh;

/// Most samples of a picture, and most surfaces of a ray, so that the picture is soon there.
const MOST_SAMPLES: u64 = 640 * 480 * 16;
const MOST_SURFACES: u32 = 50;

/// The settings of a scene file, its camera and world, and its numbers.
pub fn open(text: &str) -> Result<(Settings, View, NumberedFile), Error> {
    let read = || {
        // The mesh beside the example of the last stage: a page has no other files.
        let mesh = |name: &str| match name {
            "pyramid.obj" => Mesh::read(PYRAMID),
            _ => Err("on this page the only mesh is pyramid.obj".to_owned()),
        };
        let file = FORMAT.read(text, &mesh)?;
        let (mut settings, view) = FORMAT.scene(&file)?;
        // The same bytes sooner: a reader waits for each change of the text.
        settings.renderer = Renderer::Engine;
        let pixels = u64::from(settings.size.width()) * u64::from(settings.size.height());
        if pixels * u64::from(settings.samples) > MOST_SAMPLES {
            let most =
                format!("this page takes at most {MOST_SAMPLES} samples, as 640x480 with 16");
            return Err(file.picture.error("size", most));
        }
        if settings.depth > MOST_SURFACES {
            let most = format!("this page takes a depth of at most {MOST_SURFACES}");
            return Err(file.picture.error("depth", most));
        }
        let file = NumberedFile {
            format: FORMAT,
            text: text.to_owned(),
            file,
        };
        Ok((settings, view, file))
    };
    read().map_err(|error: scene_file::Error| Error::SceneFile(error.within(text)))
}

/// The scene of a scene file.
pub fn scene(text: &str) -> Result<Scene, Error> {
    let (defaults, _, file) = open(text)?;
    let text = text.to_owned();
    Ok(Scene::from(TracedScene {
        name: "file",
        about: "a scene of a file",
        view: Arc::new(move |_| Ok(open(&text)?.1)),
        reflects: true,
        defaults,
        file: Some(Arc::new(file)),
    }))
}
