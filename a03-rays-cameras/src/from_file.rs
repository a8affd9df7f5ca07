//! Reads scenes from files: the camera, the settings, and the scene for the program.

use std::cell::RefCell;
use std::fs::File;
use std::io::Read;
use std::path::Path;
use std::sync::Mutex;

use a02_math::{Point3, Vector3};
use common::{Color, Error, Sampling, Scene, Settings, Size};
use scene_file::{Item, SceneFile};

use crate::view::scene_of;
use crate::{Camera, OrthographicCamera, PerspectiveCamera, View};

/// A stage's function from the numbers of a file to its camera and world.
pub type MakeView = fn(&SceneFile) -> Result<View, scene_file::Error>;

/// Most bytes of a scene file and of a mesh.
const MOST_BYTES: [u64; 2] = [16 << 20, 1 << 30];

/// The scene of a file for this stage. A mistake in the file is an error with its position.
pub fn scene(path: &Path, stage: u8, make_view: MakeView) -> Result<Scene, Error> {
    let cannot_open = |reason| Error::Open {
        path: path.to_owned(),
        reason,
    };
    let bytes = read(path, MOST_BYTES[0]).map_err(cannot_open)?;
    let no_text = |_| cannot_open("it is no text in UTF-8".to_owned());
    let text = String::from_utf8(bytes).map_err(no_text)?;
    let place = path.display().to_string();
    let at_place = move |error| Error::SceneFile(format!("{place}:{error}"));
    let files = RefCell::new(vec![path.to_owned()]);
    let mesh = |name: &str| {
        let mesh = path.with_file_name(name);
        let bytes = read(&mesh, MOST_BYTES[1]);
        files.borrow_mut().push(mesh);
        bytes
    };
    let file = SceneFile::read(&text, stage, &mesh).map_err(&at_place)?;
    let defaults = settings(&file.picture).map_err(&at_place)?;
    // All constructors must accept the numbers. The first picture takes the view that they make.
    let first = Mutex::new(Some(make_view(&file).map_err(&at_place)?));
    let is_large = file.triangles > 10_000;
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let name = stem.into_owned().leak();
    let view = move |_| match first.lock().map(|mut first| first.take()) {
        Ok(Some(view)) => Ok(view),
        _ => make_view(&file).map_err(&at_place),
    };
    let scene = scene_of(name, "a scene of a file", stage > 5, view);
    let mut scene = scene.with_defaults(defaults);
    scene.is_large = is_large;
    scene.files = files.into_inner();
    Ok(scene)
}

/// The bytes of a file. The error is a clause.
fn read(path: &Path, most: u64) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    let read = File::open(path).and_then(|file| file.take(most + 1).read_to_end(&mut bytes));
    match read {
        Ok(_) if bytes.len() as u64 > most => Err(format!("it has more than {most} bytes")),
        Ok(_) => Ok(bytes),
        Err(error) => Err(error.to_string()),
    }
}

/// The settings of the table `picture`.
pub fn settings(picture: &Item) -> Result<Settings, scene_file::Error> {
    let mut settings = Settings::default();
    if let Some([width, height]) = picture.find_whole("size", u32::MAX)? {
        let size = Size::new(width, height);
        settings.size = size.map_err(|error| picture.error("size", error.to_string()))?;
    }
    if let Some([samples]) = picture.find_whole("samples", 1_000_000)? {
        if samples.isqrt().pow(2) != samples {
            return Err(picture.error("samples", "samples must be a square number, such as 16"));
        }
        settings.samples = samples;
        if samples > 1 {
            settings.sampling = Sampling::Stratified;
        }
    }
    let depth = picture.find_whole("depth", u32::MAX)?;
    settings.depth = depth.map_or(settings.depth, |[depth]| depth);
    Ok(settings)
}

/// The camera of a file.
pub fn camera(file: &SceneFile) -> Result<Box<dyn Camera>, scene_file::Error> {
    let item = &file.camera;
    let e = item.vector("eye", Point3::new)?;
    let g = item.vector("gaze", Vector3::new)?;
    let t = item.find_vector("up", Vector3::new);
    let t = t.unwrap_or(Vector3::new(0.0, 1.0, 0.0));
    match (item.find("angle"), item.find("scale")) {
        (Some(_), Some(_)) => {
            Err(item.error("scale", "a camera has an angle or a scale, not both"))
        }
        (None, Some(_)) => {
            let camera = OrthographicCamera::new(e, g, t, item.number("scale")?);
            Ok(Box::new(item.check(camera)?))
        }
        _ => {
            let camera = PerspectiveCamera::new(e, g, t, item.angle("angle")?);
            Ok(Box::new(item.check(camera)?))
        }
    }
}

/// The colour of a key, black if it is missing.
#[must_use]
pub fn color(item: &Item, key: &str) -> Color {
    let color = item.find_vector(key, Color::new);
    color.unwrap_or(Color::BLACK)
}
