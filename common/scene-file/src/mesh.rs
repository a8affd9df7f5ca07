//! `Mesh`: the triangles of an OBJ file.

use tobj::{LoadError, LoadOptions};

/// Triangles that share corners and normals.
#[derive(Debug)]
pub struct Mesh {
    models: Vec<tobj::Model>,
}

/// Three corners, and their normals if the file has them.
pub type Triangle = ([[f64; 3]; 3], Option<[[f64; 3]; 3]>);

impl Mesh {
    /// Reads an OBJ file. Polygons become triangles; its materials are ignored.
    pub fn read(mut bytes: &[u8]) -> Result<Self, String> {
        if bytes.starts_with(b"ply") {
            return Err("it is a PLY file; a program such as Blender saves it as OBJ".into());
        }
        let options = LoadOptions {
            triangulate: true,
            ignore_points: true,
            ignore_lines: true,
            ..LoadOptions::default()
        };
        let without_materials = |_: &_| Err(LoadError::OpenFileFailed);
        let read = tobj::load_obj_buf(&mut bytes, &options, without_materials);
        let (models, _) = read.map_err(|error| format!("it is no OBJ file: {error}"))?;
        let mesh = Self { models };
        if mesh.triangles().next().is_none() {
            return Err("it has no triangles, which are lines such as f 1 2 3".into());
        }
        Ok(mesh)
    }

    /// The triangles in the order of the file.
    pub fn triangles(&self) -> impl Iterator<Item = Triangle> {
        self.models.iter().flat_map(|model| {
            let mesh = &model.mesh;
            let corners = mesh.indices.chunks_exact(3);
            corners.enumerate().filter_map(|(i, indices)| {
                let normals = mesh.normal_indices.get(3 * i..3 * i + 3);
                let normals = normals.and_then(|indices| vectors(&mesh.normals, indices));
                Some((vectors(&mesh.positions, indices)?, normals))
            })
        })
    }
}

/// The three vectors of these indices; none if one is missing.
fn vectors(numbers: &[f64], indices: &[u32]) -> Option<[[f64; 3]; 3]> {
    let vector = |index: u32| numbers.as_chunks().0.get(index as usize).copied();
    let [a, b, c] = *indices.as_array()?;
    Some([vector(a)?, vector(b)?, vector(c)?])
}
