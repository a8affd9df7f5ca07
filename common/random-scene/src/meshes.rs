//! Random meshes: five by five points in a plane across an axis, some of them above or below it. Light along the
//! plane shines on smooth faces beside these points.

use std::fmt::Write;

use super::numbers::Numbers;
use super::written;

/// The meshes of a scene: ordinary, each face twice, faces that go round in both directions, neighbours whose corners
/// are almost at the same place, and with normals of its own.
pub const MESHES: [&str; 5] = ["plain", "doubled", "mixed", "cracked", "smooth"];

/// The text of an OBJ file, by the name of the mesh.
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
