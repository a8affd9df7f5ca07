//! Meshes of scene files: the same in all formats, and large ones by the engine.

use std::f64::consts::{PI, TAU};
use std::fs;

use a07_transforms::stage;
use common::{Color, Renderer, Settings, Size};
use scene_file::Mesh;

/// A PLY file of these vertices and faces: its numbers as text, or as bytes in this order.
fn ply(format: &str, vertices: &[[f64; 3]], faces: &[Vec<u32>]) -> Vec<u8> {
    let header = format!(
        "ply\nformat {format} 1.0\ncomment with an unknown property\n\
         element vertex {}\nproperty double x\nproperty double y\nproperty uchar quality\n\
         property double z\nelement face {}\nproperty list ushort int vertex_indices\nend_header\n",
        vertices.len(),
        faces.len()
    );
    let mut file = header.into_bytes();
    let mut add = |number: f64, mut little: Vec<u8>| match format {
        "ascii" => file.extend(format!("{number}\n").bytes()),
        "binary_little_endian" => file.extend(little),
        _ => {
            little.reverse();
            file.extend(little);
        }
    };
    for [x, y, z] in vertices {
        add(*x, x.to_le_bytes().into());
        add(*y, y.to_le_bytes().into());
        add(7.0, vec![7]);
        add(*z, z.to_le_bytes().into());
    }
    for face in faces {
        add(face.len() as f64, (face.len() as u16).to_le_bytes().into());
        for corner in face {
            add((*corner).into(), corner.to_le_bytes().into());
        }
    }
    file
}

#[test]
fn a_mesh_is_the_same_in_all_formats() {
    let obj = "v 0 0 0\nv 1 0 0\nv 1 1.5 0\nv 0 1 0\nv 0.1 0.5 1\nf 1 2 3 4\nf 1 2 5\n";
    let vertices = [
        [0.0; 3],
        [1.0, 0.0, 0.0],
        [1.0, 1.5, 0.0],
        [0.0, 1.0, 0.0],
        [0.1, 0.5, 1.0],
    ];
    let faces = [vec![0, 1, 2, 3], vec![0, 1, 4]];
    let triangles = |file: &[u8]| Mesh::read(file).unwrap().triangles().collect::<Vec<_>>();
    let expected = triangles(obj.as_bytes());
    assert_eq!(expected.len(), 3);
    for format in ["ascii", "binary_little_endian", "binary_big_endian"] {
        let file = ply(format, &vertices, &faces);
        assert_eq!(triangles(&file), expected, "{format}");
        for end in 0..file.len() - 1 {
            assert!(Mesh::read(&file[..end]).is_err(), "{format}, {end} bytes");
        }
        for corner in [5, u32::MAX] {
            let error = Mesh::read(&ply(format, &vertices, &[vec![0, 1, corner]])).unwrap_err();
            assert!(error.contains("a face has the corner"), "{error}");
        }
    }
}

/// A bumpy ball of 200,000 triangles, whose corners are 0.9 to 1 from its center, and whose edges
/// are shorter than 0.1: rays within 0.85 of the center hit it, and rays beyond 1 do not. The
/// camera shows a height of 3 with 101 rays, so that a ray is within 0.02 of its place.
#[test]
fn the_engine_renders_a_large_mesh() {
    const COLUMNS: u32 = 400;
    let vertex = |i: u32| {
        let [row, column] = [i / COLUMNS, i % COLUMNS].map(f64::from);
        let (height, across) = libm::sincos(PI * (row / 250.0 - 0.5));
        let (x, y) = libm::sincos(TAU * column / 400.0);
        let radius = 0.95 + 0.05 * libm::sin(row) * libm::sin(TAU * column / 8.0);
        [across * x, height, across * y].map(|share| radius * share)
    };
    let face = |i| {
        let next = i - i % COLUMNS + (i + 1) % COLUMNS;
        vec![i, next, next + COLUMNS, i + COLUMNS]
    };
    let vertices: Vec<_> = (0..251 * COLUMNS).map(vertex).collect();
    let faces: Vec<_> = (0..250 * COLUMNS).map(face).collect();
    let folder = tempfile::tempdir().unwrap();
    let [mesh, path] = ["ball.ply", "ball.toml"].map(|name| folder.path().join(name));
    fs::write(mesh, ply("binary_little_endian", &vertices, &faces)).unwrap();
    let text = "camera = { eye = [0, 0, 3], gaze = [0, 0, -1], scale = 3 }
        mesh = [{ file = 'ball.ply', color = [1, 1, 1] }]";
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
            ..0.83 => assert_eq!(*color, Color::WHITE, "{x}, {y}"),
            1.02.. => assert_eq!(*color, Color::BLACK, "{x}, {y}"),
            _ => (),
        }
    }
}
