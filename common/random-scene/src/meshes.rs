//! Random meshes: five by five points in a plane across an axis, some of them above or below it. Light along the
//! plane shines on smooth faces beside these points.

use std::fmt::Write;

use super::numbers::Numbers;
use super::written;

/// The meshes of a scene: ordinary, each face twice, faces that go round in both directions, neighbours whose corners
/// are almost at the same place, with normals of its own, of needles, closed, and ordinary in a PLY file.
pub const MESHES: [&str; 8] = [
    "plain", "doubled", "mixed", "cracked", "smooth", "needles", "closed", "ply",
];

/// The text of an OBJ or PLY file, by the name of the mesh.
pub fn mesh(name: &str, numbers: &mut Numbers) -> String {
    let (axis, mut points) = (numbers.below(3), Vec::new());
    for i in 0..25_u32 {
        let mut at = [
            f64::from(i % 5) / 2.0 - 1.0,
            f64::from(i / 5) / 2.0 - 1.0,
            0.0,
        ];
        if numbers.below(5) == 0 {
            at[2] = numbers.number() / 4.0;
        }
        if name == "needles" {
            at[1] *= 1e-6;
        }
        at.rotate_right(axis);
        points.push(numbers.at(at));
    }
    let mut faces = Vec::new();
    for [row, column] in (0..16).map(|cell| [cell / 4, cell % 4]) {
        let [a, b] = [5 * row + column, 5 * row + column + 5];
        for mut face in [[a, a + 1, b], [b, a + 1, b + 1]] {
            if name == "mixed" && numbers.below(2) == 0 {
                face.reverse();
            }
            if name == "cracked" {
                face = face.map(|corner| {
                    let almost = numbers.one_of(&[1.0, 1.0 + f64::EPSILON, 1.0 + 1e-9]);
                    points.push(points[corner].map(|x| x * almost));
                    points.len() - 1
                });
            }
            faces.push(face);
            if name == "doubled" {
                face.reverse();
                faces.push(face);
            }
        }
    }
    if name == "closed" {
        (points, faces) = octahedron(numbers);
    }
    if name == "ply" {
        return ply(&points, &faces);
    }
    let mut obj = String::new();
    for point in points {
        let _ = writeln!(obj, "v {}", written(&point, " "));
    }
    for face in faces {
        let [a, b, c] = face.map(|corner| corner + 1);
        if name == "smooth" {
            let normals = [(); 3].map(|()| format!("vn {}\n", written(&numbers.direction(), " ")));
            let _ = writeln!(obj, "{}f {a}//-3 {b}//-2 {c}//-1", normals.concat());
        } else {
            let _ = writeln!(obj, "f {a} {b} {c}");
        }
    }
    obj
}

/// A closed mesh, whose faces go round as seen from outside.
fn octahedron(numbers: &mut Numbers) -> (Vec<[f64; 3]>, Vec<[usize; 3]>) {
    let (mut points, mut faces) = (Vec::new(), Vec::new());
    for i in 0..6 {
        let mut at = [0.0; 3];
        at[i / 2] = [-1.0, 1.0][i % 2];
        points.push(numbers.at(at));
    }
    for i in 0..8 {
        let [x, y, z] = [i % 2, 2 + i / 2 % 2, 4 + i / 4];
        // An even number of negative coordinates leaves the order of the axes.
        faces.push(if (x + y + z) % 2 == 1 {
            [x, y, z]
        } else {
            [x, z, y]
        });
    }
    (points, faces)
}

fn ply(points: &[[f64; 3]], faces: &[[usize; 3]]) -> String {
    let (count, triangles) = (points.len(), faces.len());
    let mut ply = format!(
        "ply\nformat ascii 1.0\nelement vertex {count}\nproperty double x\nproperty double y\nproperty double z\n\
         element face {triangles}\nproperty list uchar int vertex_indices\nend_header\n"
    );
    for point in points {
        let _ = writeln!(ply, "{}", written(point, " "));
    }
    for [a, b, c] in faces {
        let _ = writeln!(ply, "3 {a} {b} {c}");
    }
    ply
}
