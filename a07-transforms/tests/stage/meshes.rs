//! Meshes of scene files: the same in all formats, and large ones by the engine.

use std::fs;

use a04_intersections::lab::experiments::sphere_mesh::Mesh as Sphere;
use a07_transforms::stage;
use common::{Color, Renderer, Settings, Size};
use scene_file::Mesh;

/// A square, whose numbers have any type.
const SQUARE: &str = "ply\nformat ascii 1.0\ncomment a square\nelement vertex 4\nproperty KIND x\n\
    property KIND y\nproperty KIND quality\nproperty KIND z\nelement face 1\n\
    property list KIND KIND vertex_indices\nend_header\n";
const NUMBERS: &str = "0 0 9 0  1 0 9 0  1 1 9 0  0 1 9 0  4 0 1 2 3";
/// Its half, twice.
const OBJ: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

#[test]
fn a_mesh_is_the_same_in_all_formats() {
    let expected: Vec<_> = Mesh::read(OBJ.as_bytes()).unwrap().triangles().collect();
    assert_eq!(expected.len(), 2);
    let is_right = |file: &[u8]| {
        let read = Mesh::read(file).unwrap();
        assert_eq!(read.triangles().collect::<Vec<_>>(), expected);
        for end in 0..file.len() {
            assert!(Mesh::read(&file[..end]).is_err(), "{end} bytes");
        }
    };
    is_right(&[SQUARE, NUMBERS].concat().into_bytes());
    let kinds: [(_, fn(u8) -> Vec<u8>); 5] = [
        ("char", |n| vec![n]),
        ("uint16", |n| u16::from(n).to_le_bytes().into()),
        ("int", |n| i32::from(n).to_le_bytes().into()),
        ("float", |n| f32::from(n).to_le_bytes().into()),
        ("float64", |n| f64::from(n).to_le_bytes().into()),
    ];
    for (kind, bytes) in kinds {
        let header = SQUARE.replace("KIND", kind);
        let header = header.replace("ascii", "binary_little_endian");
        let numbers = NUMBERS.split_whitespace().map(|word| word.parse().unwrap());
        is_right(&[header.into_bytes(), numbers.flat_map(bytes).collect()].concat());
    }
    for wrong in ["0 1 2 4", "0 1 2 -3", "0 1 2 x"] {
        let file = [SQUARE, &NUMBERS.replace("0 1 2 3", wrong)].concat();
        assert!(Mesh::read(file.as_bytes()).is_err(), "{wrong}");
    }
}

/// A sphere of 327,680 triangles, whose edges are shorter than 0.02: rays within 0.999 of its
/// center hit it, and rays beyond 1 do not. The camera shows a height of 3 with 101 rays, so that
/// a ray is within 0.02 of its place.
#[test]
fn the_engine_renders_a_large_mesh() {
    let sphere = Sphere::icosphere(7);
    let corners = sphere.corners.iter().map(|corner| corner.to_glam());
    let corners = corners.map(|v| format!("v {} {} {}\n", v.x, v.y, v.z));
    let faces = sphere
        .faces
        .iter()
        .map(|face| face.map(|corner| corner + 1));
    let faces = faces.map(|[a, b, c]| format!("f {a} {b} {c}\n"));
    let folder = tempfile::tempdir().unwrap();
    let [mesh, path] = ["ball.obj", "ball.toml"].map(|name| folder.path().join(name));
    fs::write(mesh, corners.chain(faces).collect::<String>()).unwrap();
    let text = "camera = { eye = [0, 0, 3], gaze = [0, 0, -1], scale = 3 }
        mesh = [{ file = 'ball.obj', color = [1, 1, 1] }]";
    fs::write(&path, text).unwrap();
    let scene = (stage().open.unwrap())(&path).unwrap();
    assert!(scene.is_large);
    let settings = Settings {
        size: Size::new(101, 101).unwrap(),
        renderer: Renderer::Engine,
        ..Settings::default()
    };
    let image = scene.render(&settings, &()).unwrap();
    for (i, color) in (0..).zip(image.pixels()) {
        let [x, y] = [i % 101, i / 101].map(|at| 0.03 * (f64::from(at) - 50.0));
        match libm::hypot(x, y) {
            ..0.97 => assert_eq!(*color, Color::WHITE, "{x}, {y}"),
            1.03.. => assert_eq!(*color, Color::BLACK, "{x}, {y}"),
            _ => (),
        }
    }
}
