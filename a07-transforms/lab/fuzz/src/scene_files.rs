//! Scene files of any bytes, and of any tables with any numbers. Each one is refused at a position
//! within it, or rendered with finite numbers by the stage that reads it.

use a03_rays_cameras::registry::Format;
use arbitrary::Unstructured;
use common::{Renderer, SceneNumber, Settings, Size, Transfer};
use random_scene::{SceneText, Style};
use scene_file::{Mesh, Meshes, SceneFile};

use crate::values::below;

/// Reads bytes as a scene file and as a mesh, and renders what is right of them.
pub fn check(bytes: &[u8]) {
    if let Ok(mut mesh) = Mesh::read(bytes) {
        check_mesh(&mut mesh, bytes);
    }
    // The file is its own mesh.
    check_text(&String::from_utf8_lossy(bytes), &|_| Mesh::read(bytes));
}

/// Reads a scene file in each stage, and renders what is right of it.
fn check_text(text: &str, meshes: Meshes) {
    let formats: [Format; 4] = [
        a04_intersections::registry::FORMAT,
        a05_lighting::registry::FORMAT,
        a06_shadows_reflection::registry::FORMAT,
        a07_transforms::registry::FORMAT,
    ];
    let settings = Settings {
        size: Size::new(3, 2).expect("a size"),
        ..Settings::default()
    };
    let of_engine = Settings {
        renderer: Renderer::Engine,
        ..settings.clone()
    };
    for format in formats {
        let file = format.read(text, meshes);
        let twice = file.and_then(|file| {
            if file.mistake.is_none() {
                check_numbers(&file, text);
            }
            Ok([(format.view)(&file)?, (format.view)(&file)?])
        });
        match twice {
            Ok([view, same]) => {
                let image = view.render(&settings, &()).expect("a picture");
                assert_eq!(image.count_non_finite(), 0, "{text}");
                let by_engine = same.render(&of_engine, &()).expect("a picture");
                assert!(by_engine == image, "{text}");
            }
            Err(error) => {
                assert!(error.at <= text.len(), "{error:?} in {text}");
                assert_eq!(error.text.lines().count(), 1, "{error:?} in {text}");
            }
        }
    }
}

/// Checks that each number of a file stands in its text, and that the file with the same value of it is
/// the same.
fn check_numbers(file: &SceneFile, text: &str) {
    let values = |numbers: &[SceneNumber]| {
        let values = numbers.iter().map(|number| number.value.to_bits());
        values.collect::<Vec<_>>()
    };
    let numbers = file.numbers(text);
    for number in &numbers {
        let written = text.get(number.bytes.clone());
        assert!(
            written.is_some_and(|it| !it.is_empty()),
            "{number:?} in {text}"
        );
        assert!(
            number.line <= text.split('\n').count(),
            "{number:?} in {text}"
        );
    }
    // One of them is enough for so long a text.
    if let Some(number) = numbers.first()
        && let Some(same) = file.with(Transfer::default(), number, number.value)
    {
        assert_eq!(values(&same.numbers(text)), values(&numbers), "{text}");
    }
}

/// Checks the numbers of a mesh, also of its computed normals.
fn check_mesh(mesh: &mut Mesh, bytes: &[u8]) {
    // A line such as f 1 1 1 1 is a face without triangles.
    let count = mesh.triangles().count();
    assert!(
        count <= bytes.len(),
        "{count} triangles of {} bytes",
        bytes.len()
    );
    mesh.set_smooth(true);
    for (corners, normals) in mesh.triangles() {
        assert!(corners.as_flattened().iter().all(|x| x.abs() <= 1e100));
        let normals = normals.unwrap_or_default();
        assert!(normals.as_flattened().iter().all(|x| x.is_finite()));
    }
    for note in mesh.notes() {
        assert_eq!(note.lines().count(), 1, "{note}");
    }
}

/// A scene file with any tables and any numbers, of which a function accepts each table.
pub fn text(u: &mut Unstructured, accepts: &dyn Fn(&SceneText) -> bool) -> SceneText {
    SceneText::new(&mut |end| below(u, end), Style::Any, 7, accepts)
}

/// Reads a scene file with any tables and any numbers.
pub fn check_structure(bytes: &[u8]) {
    let text = text(&mut Unstructured::new(bytes), &|_| true);
    check_text(&text.scene, &|name| text.mesh(name));
}
