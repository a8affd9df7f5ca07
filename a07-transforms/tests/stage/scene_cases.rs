//! Scenes as data: each scene of `tests/scenes`, after which stands the error or the note that it
//! must get, its picture in letters, how many colours its picture has, or why it is black. Each picture is
//! the same by all renderers, and from the scene's export. Empty lines stand between scenes.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::fs;
use std::path::Path;

use a07_transforms::stage;
use common::{Error, Image, Renderer, Sampling, Scene, Settings, Size, Transfer};

const PYRAMID: &str = include_str!("../../scenes/pyramid.obj");

/// The function of a stage that opens a scene file.
pub type Open = fn(&Path) -> Result<Scene, Error>;

/// A folder with the meshes of the scenes.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::create_dir(at("letters")).unwrap();
    for name in ["letters/t.obj", "line.obj", "mesh.obj"] {
        fs::copy(Path::new("tests/scenes").join(name), at(name)).unwrap();
    }
    fs::write(at("pyramid.obj"), PYRAMID).unwrap();
    folder
}

/// The scene of these bytes, or the position and the text of its error.
pub fn open_by(open: Open, text: &[u8]) -> Result<Scene, String> {
    let folder = folder();
    let path = folder.path().join("scene.toml");
    fs::write(&path, text).unwrap();
    let mut scene = open(&path).map_err(|error| {
        let error = error.to_string();
        assert_eq!(error.lines().count(), 1, "one sentence: {error}");
        assert!(error.len() < 600, "a short sentence: {error}");
        let here = folder.path().display().to_string();
        let short = error.replace(&format!("{here}/scene.toml:"), "");
        short.replace(&here, "HERE")
    })?;
    let here = format!("{}/", folder.path().display());
    for note in &mut scene.notes {
        *note = note.replace(&here, "").replace("scene.toml:", "");
    }
    Ok(scene)
}

/// The scene of a text, or the position and the text of its error.
pub fn open(text: &str) -> Result<Scene, String> {
    open_by(stage().open.unwrap(), text.as_bytes())
}

/// The picture of a scene of this text, which must be the same by all renderers, and from the
/// scene's export.
pub fn picture(text: &str, size: [u32; 2]) -> Image {
    let scene = open(text).unwrap_or_else(|error| panic!("{error}:\n{text}"));
    picture_of(
        stage().open.unwrap(),
        &scene,
        Size::new(size[0], size[1]).unwrap(),
    )
}

pub fn picture_of(open: Open, scene: &Scene, size: Size) -> Image {
    let picture = |scene: &Scene, renderer| {
        let settings = Settings {
            size,
            samples: 1,
            sampling: Sampling::Center,
            renderer,
            ..scene.defaults.clone()
        };
        scene.render(&settings, &()).unwrap()
    };
    let [lesson, engine, all_work] = Renderer::ALL.map(|renderer| picture(scene, renderer));
    let name = scene.name;
    assert!(engine == lesson, "{name}: the engine differs");
    assert!(all_work == lesson, "{name}: all work differs");
    let export = scene.rays().unwrap().export("toml", &scene.defaults);
    let export = export.unwrap_or_else(|error| panic!("{name}: {error}"));
    let again = open_by(open, export.as_bytes());
    let again = again.unwrap_or_else(|error| panic!("the export of {name}, {error}:\n{export}"));
    let again = picture(&again, Renderer::Engine);
    let bytes = |image: &Image| image.to_rgb8(Transfer::Linear);
    assert!(
        bytes(&again) == bytes(&lesson),
        "the export of {name} differs:\n{export}"
    );
    lesson
}

/// A picture as rows of letters: the first of the name of a color, or a dot for black.
fn letters(image: &Image) -> String {
    let mut text = String::new();
    for row in image.rows() {
        text += "\n# ";
        for color in row {
            text.push(match color.to_bytes() {
                [0, 0, 0] => '.',
                [255, 255, 255] => 'w',
                [255, 0, 0] => 'r',
                [0, 0, 255] => 'b',
                other => panic!("{other:?}"),
            });
        }
    }
    text
}

/// The scenes of a file of `tests/scenes` that get something else, and what they get.
pub fn wrong_scenes(file: &Path, open: Open) -> String {
    let text = fs::read_to_string(file).unwrap();
    let mut wrong = String::new();
    for case in text.trim_end().split("\n\n") {
        let marks = [
            "# error: ",
            "# note: ",
            "# picture:",
            "# colors: ",
            "# black: ",
        ];
        let ends = marks.iter().filter_map(|mark| case.find(mark));
        let (text, expected) = case.split_at(ends.min().expect(case));
        let found = match open_by(open, text.as_bytes()) {
            Err(error) => format!("# error: {error}"),
            Ok(scene) => {
                let mut found = Vec::new();
                if expected.contains("# note: ") {
                    let notes = scene.notes.join(", ");
                    let notes = if notes.is_empty() { "none" } else { &notes };
                    found.push(format!("# note: {notes}"));
                }
                let image = || picture_of(open, &scene, scene.defaults.size);
                if expected.contains("# picture:") {
                    found.push(format!("# picture:{}", letters(&image())));
                }
                if let Some((_, least)) = expected.split_once("# colors: at least ") {
                    let pixels = image().to_rgb8(Transfer::Linear);
                    let colors: BTreeSet<_> = pixels.as_chunks::<3>().0.iter().collect();
                    let is_right = colors.len() >= least.trim().parse().unwrap();
                    let count = format!("# colors: {}", colors.len());
                    found.push(if is_right { expected.to_owned() } else { count });
                }
                if expected.contains("# black: ") {
                    let bytes = image().to_rgb8(Transfer::Linear);
                    assert!(bytes.iter().all(|byte| *byte == 0), "{text}");
                    let rays = scene.rays().unwrap();
                    let reason = rays.why_black(&scene.defaults).unwrap();
                    let reason = reason.as_deref().unwrap_or("none");
                    found.push(format!("# black: {reason}"));
                }
                found.join("\n")
            }
        };
        if found != expected {
            let _ = writeln!(wrong, "\n{case}\nand not\n{found}");
        }
    }
    wrong
}
