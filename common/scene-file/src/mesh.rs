//! `Mesh`: the triangles of an OBJ or PLY file.

use crate::{obj, ply};

/// The index of the normal of a corner without one.
pub const NONE: u32 = u32::MAX;

/// Triangles that share corners and normals.
#[derive(Debug, Default)]
pub struct Mesh {
    pub(crate) corners: Vec<[f64; 3]>,
    pub(crate) normals: Vec<[f64; 3]>,
    /// For each corner of a triangle its index and that of its normal.
    triangles: Vec<[[u32; 2]; 3]>,
}

/// Three corners, and their normals if all have one.
pub type Triangle = ([[f64; 3]; 3], Option<[[f64; 3]; 3]>);

impl Mesh {
    /// Reads an OBJ or PLY file. Polygons become triangles; its materials are ignored.
    pub fn read(bytes: &[u8]) -> Result<Self, String> {
        // Numbers of corners begin with 1 in OBJ files.
        let (format, first, mesh) = if bytes.starts_with(b"ply") {
            ("PLY", 0, ply::read(bytes))
        } else {
            ("OBJ", 1, obj::read(bytes))
        };
        let mesh = mesh.and_then(|mesh| mesh.checked(first));
        let mesh = mesh.map_err(|error| format!("a mistake in this {format}: {error}"))?;
        if mesh.triangles.is_empty() {
            return Err(
                "it has no faces; a mesh is an OBJ file with lines as f 1 2 3, or a PLY file"
                    .into(),
            );
        }
        Ok(mesh)
    }

    /// The mesh, if no face has a corner or a normal that is missing; their numbers begin with
    /// `first`.
    fn checked(self, first: u64) -> Result<Self, String> {
        for (i, name, list) in [(0, "corner", &self.corners), (1, "normal", &self.normals)] {
            let count = list.len();
            let is_missing = |index: &u32| *index as usize >= count && (i, *index) != (1, NONE);
            let mut indices = self.triangles.as_flattened().iter().map(|corner| corner[i]);
            if let Some(index) = indices.find(is_missing) {
                let number = u64::from(index) + first;
                return Err(format!(
                    "a face has the {name} {number} of {count}, from {first}"
                ));
            }
        }
        Ok(self)
    }

    /// Adds the triangles of a face from its first corner; none if it has less than three.
    pub(crate) fn add_face(&mut self, corners: &[[u32; 2]]) -> Option<()> {
        let [first, others @ ..] = corners else {
            return None;
        };
        let triangles = others.windows(2).map(|side| [*first, side[0], side[1]]);
        self.triangles.extend(triangles);
        (others.len() > 1).then_some(())
    }

    /// The triangles in the order of the file.
    pub fn triangles(&self) -> impl Iterator<Item = Triangle> {
        self.triangles.iter().map(|triangle| {
            let corners = triangle.map(|[corner, _]| self.corners[corner as usize]);
            let normals = triangle.map(|[_, normal]| self.normals.get(normal as usize).copied());
            let normals = match normals {
                [Some(a), Some(b), Some(c)] => Some([a, b, c]),
                _ => None,
            };
            (corners, normals)
        })
    }
}
