//! Scene files: an example with every key, and what becomes of it in mistaken hands.

use std::path::Path;
use std::{env, fs};

use a07_transforms::stage;
use common::{Error, Renderer, Scene, Settings, Size, Transfer, picture_file};

const EXAMPLE: &str = include_str!("../../scenes/shapes.toml");
const PYRAMID: &str = include_str!("../../scenes/pyramid.obj");

/// Opens this text as a scene file, beside the mesh; the error of a mistake as text.
fn open(folder: &Path, text: &[u8]) -> Result<Scene, String> {
    let path = folder.join("scene.toml");
    fs::write(&path, text).unwrap();
    (stage().open.unwrap())(&path).map_err(|error| {
        assert_eq!(error.exit_code(), 1);
        let error = error.to_string();
        assert_eq!(error.lines().count(), 1, "one sentence: {error}");
        assert!(error.len() < 600, "a short sentence: {error}");
        error
    })
}

/// A folder with the mesh of the example.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("pyramid.obj"), PYRAMID).unwrap();
    folder
}

#[test]
fn the_example_has_every_key_and_the_schema_is_current() {
    for key in scene_file::KINDS.iter().flat_map(|kind| &kind.keys) {
        let has_it = EXAMPLE.contains(&format!("{} = ", key.name));
        assert!(has_it || key.name == "inverse", "{}", key.name);
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/schema.json");
    if env::var_os("INSTA_UPDATE").is_some() {
        fs::write(&path, scene_file::schema()).unwrap();
    }
    assert_eq!(fs::read_to_string(&path).unwrap(), scene_file::schema());
}

#[test]
fn all_scenes_have_the_same_picture_by_all_renderers_and_from_their_export() {
    let stage_folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    for file in fs::read_dir(stage_folder.join("scenes")).unwrap() {
        let path = file.unwrap().path();
        if path.extension() != Some("toml".as_ref()) {
            continue;
        }
        let scene = (stage().open.unwrap())(&path).unwrap();
        let rays = scene.rays().unwrap();
        let again = rays.export("toml", &scene.defaults).unwrap();
        let again = open(folder().path(), again.as_bytes()).unwrap();
        let render = |scene: &Scene, size, renderer| {
            let settings = Settings {
                size,
                renderer,
                ..scene.defaults.clone()
            };
            let image = scene.render(&settings, &()).unwrap();
            image.to_rgb8(Transfer::Linear)
        };
        let small = Size::new(16, 12).unwrap();
        let expected = render(&scene, small, Renderer::Engine);
        for renderer in Renderer::ALL {
            assert!(
                render(&scene, small, renderer) == expected,
                "{path:?} by {renderer:?}"
            );
            assert!(
                render(&again, small, renderer) == expected,
                "{path:?} by {renderer:?}"
            );
        }
        if scene.name == "shapes" {
            let book =
                picture_file::open(&stage_folder.join("../book/src/pictures/scene-file.png"));
            let book = book.unwrap();
            let drawn = render(&scene, book.size(), Renderer::Engine);
            assert!(drawn == book.to_rgb8(Transfer::Linear));
        }
    }
}

/// The example with another value in each line that has one, with the number of the line.
fn with_values(value: &str) -> impl Iterator<Item = (usize, String)> {
    let lines: Vec<_> = EXAMPLE.lines().collect();
    (0..lines.len()).filter_map(move |i| {
        let (key, _) = lines[i].split_once(" = ")?;
        // A step stays in its braces.
        let end = if lines[i].ends_with("},") { " }," } else { "" };
        let mut changed = lines.clone();
        let line = format!("{key} = {value}{end}");
        changed[i] = &line;
        Some((i + 1, changed.join("\n")))
    })
}

#[test]
fn each_mistake_is_refused_in_a_sentence_with_its_position() {
    let folder = folder();
    let wrong = "nan|inf|[[1], 2]|1e999|{}|\"no\\u0000such\"|1979-05-27";
    for (line, text) in wrong.split('|').flat_map(with_values) {
        let error = open(folder.path(), text.as_bytes()).err();
        let error = error.unwrap_or_else(|| panic!("accepted:\n{text}"));
        // A list of steps goes on behind its line.
        let goes_on = EXAMPLE.lines().nth(line - 1).unwrap().ends_with('[');
        let place = format!("scene.toml:{line}:");
        assert!(error.contains(&place) || goes_on, "{error}, not {place}");
    }
}

#[test]
fn other_files_than_scenes_and_meshes_are_refused() {
    let folder = folder();
    let utf_16: Vec<u8> = EXAMPLE.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let groups = format!("[[{}sphere]]", "group.".repeat(5_000));
    let brackets = "a = ".to_owned() + &"[".repeat(100_000);
    let large = "#".repeat((16 << 20) + 1);
    let cut_off = &EXAMPLE[..EXAMPLE.len() - 9];
    let texts = [&*groups, &brackets, &large, "", cut_off, "[camera"].map(str::as_bytes);
    for text in texts.into_iter().chain([&*utf_16, b"\xff"]) {
        assert!(open(folder.path(), text).is_err());
    }
    let mesh = folder.path().join("pyramid.obj");
    let of_mesh = |text: &str| {
        fs::write(&mesh, text).unwrap();
        open(folder.path(), EXAMPLE.as_bytes())
    };
    for text in "|f 1 2 3|v 0 0 0\nf 1 2 3|v a|ply\n|v 1e999 0 0\nf 1 1 1|f -9 1 1".split('|') {
        let error = of_mesh(text).err().unwrap();
        assert!(error.contains("scene.toml:"), "{error}");
    }
    let triangles = "f 1 2 3\n".repeat(10_001);
    let large = of_mesh(&format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{triangles}"));
    assert!(large.unwrap().is_large);
    fs::remove_file(&mesh).unwrap();
    assert!(open(folder.path(), EXAMPLE.as_bytes()).is_err());
    fs::create_dir(&mesh).unwrap();
    assert!(open(folder.path(), EXAMPLE.as_bytes()).is_err());
    let opened = (stage().open.unwrap())(folder.path());
    assert!(matches!(opened, Err(Error::Open { .. })));
}
