//! `Format`: how a stage reads scene files.

use std::cell::{Cell, RefCell};
use std::fs;
use std::path::Path;

use common::{Error, Sampling, Scene, Settings, Size, file, text};
use scene_file::{FirstMistake, Item, Mesh, Meshes, SceneFile};

use crate::registry::NumberedFile;
use crate::{View, Views};

/// Most bytes of a scene file, and of a mesh.
const MAX_FILE_BYTES: u64 = 16 << 20;
const MAX_MESH_BYTES: u64 = 1 << 30;

/// How a stage reads scene files.
#[derive(Clone, Copy)]
pub struct Format {
    /// The number of the stage.
    pub stage: u8,
    /// Makes the camera and the world of the numbers of a file.
    pub view: fn(&SceneFile) -> Result<View, scene_file::Error>,
}

impl Format {
    /// Reads the text of a scene file.
    pub fn read(&self, text: &str, meshes: Meshes) -> Result<SceneFile, scene_file::Error> {
        SceneFile::read(text, self.stage, meshes)
    }

    /// The settings, the camera and the world of a file. The error is the first mistake in it.
    pub fn scene(&self, file: &SceneFile) -> Result<(Settings, View), scene_file::Error> {
        let mut first = FirstMistake::of(file);
        let settings = first.keep(settings(&file.picture));
        let view = first.keep((self.view)(file));
        first.result(settings.zip(view))
    }

    /// Opens the scene of a file. A mistake in the file is an error with its position.
    pub fn open(self, path: &Path) -> Result<Scene, Error> {
        let cannot_open = |reason| Error::Open {
            path: path.to_owned(),
            reason,
        };
        let bytes = file::read(Path::new(""), path, MAX_FILE_BYTES).map_err(cannot_open)?;
        let text = text::from_file(bytes).map_err(cannot_open)?;
        let (files, triangles) = (RefCell::new(vec![path.to_owned()]), Cell::new(0));
        let folder = path.parent().unwrap_or(path);
        // Of a scene file that is reached by a link, the meshes may lie beside the file itself.
        let target = fs::canonicalize(path).unwrap_or_default();
        let mesh = |name: &str| {
            let is_beside_target =
                |target: &&Path| !folder.join(name).exists() && target.join(name).exists();
            let folder = target.parent().filter(is_beside_target).unwrap_or(folder);
            let bytes = file::read(folder, name.as_ref(), MAX_MESH_BYTES);
            files.borrow_mut().push(folder.join(name));
            let mesh = Mesh::read(&bytes?)?;
            triangles.update(|before| before + mesh.triangles().count());
            Ok(mesh)
        };
        let file = self.read(&text, &mesh);
        let place = text::path(path);
        let notes = file.as_ref().map(|file| file.notes(&place, &text));
        let notes = notes.unwrap_or_default();
        let at_text = |error| at_place(&place, &text, &error);
        let file = file.map_err(at_text)?;
        // All constructors must accept the numbers.
        let (defaults, _) = self.scene(&file).map_err(at_text)?;
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let views = Views::File(Box::new(NumberedFile {
            format: self,
            text: text.into(),
            file,
        }));
        let mut scene = Scene::traced(stem.into_owned().leak(), "a scene of a file", views)
            .with_defaults(defaults);
        scene.uses.depth = self.stage > 5;
        scene.is_large = triangles.get() > 10_000;
        scene.files = files.into_inner();
        scene.notes = notes;
        Ok(scene)
    }
}

/// The error of a mistake in a file of this name and this text.
fn at_place(name: &str, text: &str, mistake: &scene_file::Error) -> Error {
    let mistake = mistake.within(text);
    Error::SceneFile(text::visible(&format!("{name}:{mistake}")))
}

/// The settings of the table `picture`.
pub fn settings(picture: &Item) -> Result<Settings, scene_file::Error> {
    let mut settings = Settings::default();
    if let Some([sides]) = picture.find_rows("size") {
        let [width, height] = sides.map(|side| side as u32);
        settings.size = picture.check(Size::new(width, height))?;
    }
    if let Some([[samples]]) = picture.find_rows("samples") {
        settings.samples = samples as u32;
        if samples > 1e6 || settings.samples.isqrt().pow(2) != settings.samples {
            let text = "samples must be a square number up to 1000000, such as 16";
            return Err(picture.error("samples", text));
        }
        if samples > 1.0 {
            settings.sampling = Sampling::Stratified;
        }
    }
    if let Some([[depth]]) = picture.find_rows("depth") {
        settings.depth = depth as u32;
        if settings.depth > Settings::MAX_DEPTH {
            let most = Settings::MAX_DEPTH;
            let text = format!("depth must be a whole number from 1 to {most}");
            return Err(picture.error("depth", text));
        }
    }
    Ok(settings)
}
