//! Computed normals, most of them of an octahedron, whose corners lie on the axes: by symmetry the normal at
//! each corner goes along its axis, however the file gives the faces.

use std::fmt::Write;

use scene_file::Mesh;

use super::SQUARE;

const CORNERS: [[f64; 3]; 6] = [
    [1.0, 0.0, 0.0],
    [-1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.0, 0.0, -1.0],
];

/// The faces, which go round counterclockwise, seen from outside.
fn faces() -> Vec<[usize; 3]> {
    let mut faces = Vec::new();
    for x in [0, 1] {
        for y in [2, 3] {
            for z in [4, 5] {
                let is_even = (x + y + z) % 2 == 0;
                faces.push(if is_even { [x, y, z] } else { [x, z, y] });
            }
        }
    }
    faces
}

fn reversed([a, b, c]: [usize; 3]) -> [usize; 3] {
    [a, c, b]
}

/// An OBJ of these faces, each with corners of its own that are off by up to `apart`.
fn with_own_corners(faces: &[[usize; 3]], apart: f64) -> String {
    let mut file = String::new();
    for (i, corner) in faces.as_flattened().iter().enumerate() {
        let [x, y, z] = CORNERS[*corner];
        let off = apart * libm::sin(i as f64 * 0.7);
        writeln!(file, "v {} {} {}", x + off, y - off, z + off).unwrap();
    }
    for i in 0..faces.len() {
        writeln!(file, "f {} {} {}", 3 * i + 1, 3 * i + 2, 3 * i + 3).unwrap();
    }
    file
}

fn read(file: &str) -> Mesh {
    let mut mesh = Mesh::read(file.as_bytes()).unwrap();
    mesh.set_smooth(true);
    mesh
}

/// Asserts that every normal goes along the axis of its corner, with all normals of a triangle
/// outwards or all inwards, and that the note counts all triangles.
fn assert_round(mesh: &Mesh, within: f64) {
    let mut count = 0;
    for (corners, normals) in mesh.triangles() {
        let normals = normals.expect("a smooth triangle");
        let mut signs = Vec::new();
        for (corner, normal) in corners.iter().zip(normals) {
            let dot: f64 = corner.iter().zip(normal).map(|(a, b)| a * b).sum();
            let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
            let cosine = dot / length;
            assert!(cosine.abs() > 1.0 - within, "{corner:?} {normal:?}");
            signs.push(cosine > 0.0);
        }
        assert!(signs.iter().all(|sign| *sign == signs[0]), "{corners:?}");
        count += 1;
    }
    let note = format!(
        "smooth, with computed normals for {count} of {count} triangles, for which the file has none"
    );
    assert_eq!(mesh.notes(), [note]);
}

#[test]
fn faces_may_go_round_in_either_direction_and_be_there_several_times() {
    let faces = faces();
    let mixed: Vec<_> = (0..)
        .zip(&faces)
        .map(|(i, face)| if i % 3 == 0 { reversed(*face) } else { *face })
        .collect();
    let all_reversed: Vec<_> = faces.iter().copied().map(reversed).collect();
    let some_doubled = [&faces[..], &all_reversed[2..5]].concat();
    let doubled = [&faces[..], &all_reversed].concat();
    let thrice = [&mixed[..], &faces, &all_reversed].concat();
    for given in [
        &faces,
        &mixed,
        &all_reversed,
        &some_doubled,
        &doubled,
        &thrice,
    ] {
        assert_round(&read(&with_own_corners(given, 0.0)), 1e-15);
    }
}

#[test]
fn corners_that_rounding_keeps_apart_are_one() {
    let faces = faces();
    for apart in [1e-16, 1e-12, 1e-7, 1e-5, 2e-4] {
        assert_round(
            &read(&with_own_corners(&faces, apart)),
            10.0 * apart + 1e-15,
        );
    }
}

#[test]
fn faces_that_stay_flat_are_counted() {
    let faces = faces();
    let flat = |count| {
        format!(
            "flat in spite of smooth = true: {count}, with no side in common with another to a \
             thousandth of its length, or too narrow, or with normals that cancel out"
        )
    };
    // Corners too far apart; a face and its back; and one that touches others at a corner only.
    for (file, count) in [
        (with_own_corners(&faces, 0.1), "8 triangles"),
        (
            with_own_corners(&[faces[0], reversed(faces[0])], 0.0),
            "2 triangles",
        ),
        (with_own_corners(&[faces[0], faces[3]], 0.0), "2 triangles"),
        (with_own_corners(&faces[..1], 0.0), "1 triangle"),
    ] {
        let mesh = read(&file);
        assert!(
            mesh.triangles().all(|(_, normals)| normals.is_none()),
            "{file}"
        );
        assert_eq!(mesh.notes(), [flat(count)], "{file}");
    }
}

/// A globe has a pole of many corners that are off by the rounding of the sine of 180 degrees.
#[test]
fn the_corners_at_a_pole_are_one() {
    let mut file = String::new();
    let (rows, columns) = (6, 12);
    for row in 0..=rows {
        for column in 0..=columns {
            let [latitude, longitude] =
                [(row, rows, 1.0), (column, columns, 2.0)].map(|(i, count, turns)| {
                    turns * std::f64::consts::PI * f64::from(i) / f64::from(count)
                });
            let (radius, height) = (libm::sin(latitude), libm::cos(latitude));
            let (x, z) = (radius * libm::cos(longitude), radius * libm::sin(longitude));
            writeln!(file, "v {x} {height} {z}").unwrap();
        }
    }
    for row in 0..rows {
        for column in 0..columns {
            let a = row * (columns + 1) + column + 1;
            let below = a + columns + 1;
            writeln!(
                file,
                "f {a} {} {below}\nf {} {} {below}",
                a + 1,
                a + 1,
                below + 1
            )
            .unwrap();
        }
    }
    for (corners, normals) in read(&file).triangles() {
        let Some(normals) = normals else {
            // Two of its corners are the pole.
            continue;
        };
        for (corner, normal) in corners.iter().zip(normals) {
            let dot: f64 = corner.iter().zip(normal).map(|(a, b)| a * b).sum();
            let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
            let is_pole = corner[1].abs() > 0.999;
            let least = if is_pole { 1.0 - 1e-12 } else { 0.98 };
            assert!((dot / length).abs() > least, "{corner:?} {normal:?}");
        }
    }
}

/// At the corner (0, 0, 0) a right angle of the plane z = 0, divided into two faces, meets right
/// angles of the planes x = 0 and y = 0: weighted by angle, the three planes count the same.
#[test]
fn normals_are_weighted_by_angle() {
    let corner = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n\
                  f 1 2 3\nf 1 3 4\nf 1 4 5\nf 1 5 2\n";
    let mut mesh = read(corner);
    for (_, normals) in mesh.triangles() {
        let [normal, ..] = normals.unwrap();
        let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
        for x in normal {
            assert!((x / length - 1.0 / 3_f64.sqrt()).abs() < 1e-15);
        }
    }
    mesh.set_smooth(false);
    assert!(mesh.triangles().all(|(_, normals)| normals.is_none()));
}

#[test]
fn normals_of_a_file_stay() {
    let mesh = read(&[SQUARE, "vn 1 0 0\nf 1//1 2//1 3//1\nf 1//1 3 4//7"].concat());
    let normals: Vec<_> = mesh.triangles().map(|(_, normals)| normals).collect();
    assert_eq!(normals[0], Some([[1.0, 0.0, 0.0]; 3]));
    let [first, second, third] = normals[1].unwrap();
    assert_eq!(first, [1.0, 0.0, 0.0]);
    for computed in [second, third] {
        assert!(computed[0] == 0.0 && computed[1] == 0.0 && computed[2] > 0.0);
    }
}
