//! Meshes of scene files: the same in all formats, and large ones by the engine.

use std::fs;

use a04_intersections::lab::experiments::sphere_mesh::Mesh as Sphere;
use a07_transforms::stage;
use common::{Renderer, Settings, Size, Transfer};
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
    let kinds: [(_, fn(u8) -> Vec<u8>); 3] = [
        ("char", |n| vec![n]),
        ("int", |n| i32::from(n).to_le_bytes().into()),
        ("float", |n| f32::from(n).to_le_bytes().into()),
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

/// A sphere of 327,680 triangles is within 2e-5 of a sphere, and no ray passes that near to its
/// edge.
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
    let picture = |shape: &str| {
        let camera = "camera = { eye = [0, 0, 3], gaze = [0, 0, -1], scale = 3 }";
        fs::write(&path, format!("{camera}\n{shape}\ncolor = [1, 1, 1]\n")).unwrap();
        let scene = (stage().open.unwrap())(&path).unwrap();
        let settings = Settings {
            size: Size::new(40, 30).unwrap(),
            renderer: Renderer::Engine,
            ..scene.defaults.clone()
        };
        let image = scene.render(&settings, &()).unwrap();
        (scene.is_large, image.to_rgb8(Transfer::Linear))
    };
    let (is_large, expected) = picture("[[sphere]]\ncenter = [0, 0, 0]\nradius = 1");
    assert!(!is_large && expected.contains(&255) && expected.contains(&0));
    assert!(picture("[[mesh]]\nfile = 'ball.obj'") == (true, expected));
}
