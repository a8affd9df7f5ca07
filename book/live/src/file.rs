//! Scenes of the text that a reader writes on the page, as a scene file of the last stage.

use a03_rays_cameras::Views;
use a03_rays_cameras::registry::NumberedFile;
use a07_transforms::registry::FORMAT;
use a07_transforms::registry::example_files::PYRAMID;
use common::{Error, Renderer, Scene, Settings};
use scene_file::{Mesh, SceneFile};

/// Most samples of a picture, and most surfaces of a ray, so that the picture is soon there.
const MAX_SAMPLES: u64 = 640 * 480 * 16;
const MAX_SURFACES: u32 = 50;

/// The scene of a scene file.
pub fn scene(text: &str) -> Result<Scene, Error> {
    let (defaults, file) = numbered(text)?;
    let scene = Scene::traced("file", "a scene of a file", Views::File(Box::new(file)));
    Ok(scene.reflecting().with_defaults(defaults))
}

/// The settings of a scene file, and its numbers.
pub fn numbered(text: &str) -> Result<(Settings, NumberedFile), Error> {
    let (defaults, file) = read(text).map_err(|error| Error::SceneFile(error.within(text)))?;
    let file = NumberedFile {
        format: FORMAT,
        text: text.into(),
        file,
    };
    Ok((defaults, file))
}

/// The settings of a scene file, and its tables.
fn read(text: &str) -> Result<(Settings, SceneFile), scene_file::Error> {
    // The mesh beside the example of the last stage: a page has no other files.
    let mesh = |name: &str| match name {
        "pyramid.obj" => Mesh::read(PYRAMID),
        _ => Err("on this page the only mesh is pyramid.obj".to_owned()),
    };
    let file = FORMAT.read(text, &mesh)?;
    let (mut settings, _) = FORMAT.scene(&file)?;
    // The same bytes sooner: a reader waits for each change of the text.
    settings.renderer = Renderer::Engine;
    let pixels = u64::from(settings.size.width()) * u64::from(settings.size.height());
    if pixels * u64::from(settings.samples) > MAX_SAMPLES {
        let most = format!("this page takes at most {MAX_SAMPLES} samples, as 640x480 with 16");
        return Err(file.picture.error("size", most));
    }
    if settings.depth > MAX_SURFACES {
        let most = format!("this page takes a depth of at most {MAX_SURFACES}");
        return Err(file.picture.error("depth", most));
    }
    Ok((settings, file))
}
