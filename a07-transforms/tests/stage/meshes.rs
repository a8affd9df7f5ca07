//! Meshes of scene files: the same in all formats, and large ones by the engine.

use std::fs;

use a04_intersections::lab::experiments::sphere_mesh::Mesh as Sphere;
use a07_transforms::stage;
use common::{Color, Renderer, Settings, Size};
use scene_file::Mesh;

/// A PLY file of a sphere: its numbers as text, or as bytes.
fn ply(format: &str, sphere: &Sphere) -> Vec<u8> {
    let header = format!(
        "ply\nformat {format} 1.0\ncomment with an unknown property\nelement vertex {}\n\
         property double x\nproperty double y\nproperty uchar quality\nproperty double z\n\
         element face {}\nproperty list ushort int vertex_indices\nend_header\n",
        sphere.corners.len(),
        sphere.faces.len()
    );
    let mut file = header.into_bytes();
    let mut add = |number: f64, bytes: &[u8]| match format {
        "ascii" => file.extend(format!("{number}\n").bytes()),
        _ => file.extend(bytes),
    };
    for corner in &sphere.corners {
        let [x, y, z] = corner.to_glam().to_array();
        for (number, bytes) in [
            (x, &x.to_le_bytes()[..]),
            (y, &y.to_le_bytes()),
            (7.0, &[7]),
        ] {
            add(number, bytes);
        }
        add(z, &z.to_le_bytes());
    }
    for face in &sphere.faces {
        add(3.0, &3_u16.to_le_bytes());
        for corner in face {
            add(*corner as f64, &(*corner as i32).to_le_bytes());
        }
    }
    file
}

#[test]
fn a_mesh_is_the_same_in_all_formats() {
    let mut sphere = Sphere::icosphere(0);
    let triangles = |file: &[u8]| Mesh::read(file).unwrap().triangles().collect::<Vec<_>>();
    let corners = sphere.corners.iter().map(|corner| corner.to_glam());
    let corners = corners.map(|v| format!("v {} {} {}\n", v.x, v.y, v.z));
    let faces = sphere
        .faces
        .iter()
        .map(|face| face.map(|corner| corner + 1));
    let faces = faces.map(|[a, b, c]| format!("f {a} {b} {c}\n"));
    let expected = triangles(corners.chain(faces).collect::<String>().as_bytes());
    let [ascii, binary] = ["ascii", "binary_little_endian"].map(|format| ply(format, &sphere));
    for file in [&ascii, &binary] {
        assert_eq!(triangles(file), expected);
        for end in 0..file.len() - 3 {
            assert!(Mesh::read(&file[..end]).is_err(), "{end} bytes");
        }
    }
    let square = "ply\nformat ascii 1.0\nelement vertex 4\nproperty int x\nproperty int y\n\
        property int z\nelement face 1\nproperty list int int vertex_index\nend_header\n\
        0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
    let [a, b, c, d] = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
    ];
    assert_eq!(
        triangles(square.as_bytes()),
        [([a, b, c], None), ([a, c, d], None)]
    );
    for wrong in ["0 1 2 4", "0 1 2 -3", "0 1 2 x"] {
        let file = square.replace("0 1 2 3", wrong);
        assert!(Mesh::read(file.as_bytes()).is_err(), "{wrong}");
    }
    sphere.faces[19][2] = 12;
    assert!(Mesh::read(&ply("binary_little_endian", &sphere)).is_err());
}

/// A sphere of 327,680 triangles, whose edges are shorter than 0.02: rays within 0.999 of its
/// center hit it, and rays beyond 1 do not. The camera shows a height of 3 with 101 rays, so that
/// a ray is within 0.02 of its place.
#[test]
fn the_engine_renders_a_large_mesh() {
    let folder = tempfile::tempdir().unwrap();
    let [mesh, path] = ["ball.ply", "ball.toml"].map(|name| folder.path().join(name));
    fs::write(mesh, ply("binary_little_endian", &Sphere::icosphere(7))).unwrap();
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
            ..0.97 => assert_eq!(*color, Color::WHITE, "{x}, {y}"),
            1.03.. => assert_eq!(*color, Color::BLACK, "{x}, {y}"),
            _ => (),
        }
    }
}
