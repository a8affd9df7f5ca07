//! `Mesh`: the triangles of an OBJ or PLY file.

use tobj::{LoadError, LoadOptions};

use crate::ply;

/// Triangles that share corners and normals.
#[derive(Debug)]
pub struct Mesh(Vec<tobj::Mesh>);

/// Three corners, and their normals if the file has them.
pub type Triangle = ([[f64; 3]; 3], Option<[[f64; 3]; 3]>);

impl Mesh {
    /// Reads an OBJ or PLY file. Polygons become triangles; its materials are ignored.
    pub fn read(mut bytes: &[u8]) -> Result<Self, String> {
        let options = LoadOptions {
            triangulate: true,
            ignore_points: true,
            ignore_lines: true,
            ..LoadOptions::default()
        };
        let mesh = Self(if bytes.starts_with(b"ply") {
            vec![ply::read(bytes).map_err(|error| format!("a mistake in this PLY: {error}"))?]
        } else {
            // `tobj` takes such a face for a line, and leaves it out.
            let mut lines = bytes.split(|byte| *byte == b'\n');
            if lines.any(|line| line.starts_with(b"f ") && words(line) < 4) {
                return Err("a face of this OBJ has less than three corners".to_owned());
            }
            let without_materials = |_: &_| Err(LoadError::OpenFileFailed);
            let read = tobj::load_obj_buf(&mut bytes, &options, without_materials);
            let (models, _) = read.map_err(|error| match error {
                LoadError::FaceVertexOutOfBounds => {
                    "a face of this OBJ has a corner that it lacks; the first is 1".to_owned()
                }
                LoadError::PositionParseError => {
                    "a corner of this OBJ is not three numbers, as v 0 1 0".to_owned()
                }
                error => format!("a mistake in this OBJ: {error}"),
            })?;
            models.into_iter().map(|model| model.mesh).collect()
        });
        if mesh.triangles().next().is_none() {
            return Err(
                "it has no faces; a mesh is an OBJ file with lines as f 1 2 3, or a PLY file"
                    .into(),
            );
        }
        Ok(mesh)
    }

    /// The triangles in the order of the file.
    pub fn triangles(&self) -> impl Iterator<Item = Triangle> {
        self.0.iter().flat_map(|mesh| {
            let corners = mesh.indices.chunks_exact(3);
            corners.enumerate().filter_map(|(i, indices)| {
                let normals = mesh.normal_indices.get(3 * i..3 * i + 3);
                let normals = normals.and_then(|indices| vectors(&mesh.normals, indices));
                Some((vectors(&mesh.positions, indices)?, normals))
            })
        })
    }
}

fn words(line: &[u8]) -> usize {
    let words = line.split(u8::is_ascii_whitespace);
    words.filter(|word| !word.is_empty()).count()
}

/// The three vectors of these indices; none if one is missing.
fn vectors(numbers: &[f64], indices: &[u32]) -> Option<[[f64; 3]; 3]> {
    let vector = |index: u32| numbers.as_chunks().0.get(index as usize).copied();
    let [a, b, c] = *indices.as_array()?;
    Some([vector(a)?, vector(b)?, vector(c)?])
}
