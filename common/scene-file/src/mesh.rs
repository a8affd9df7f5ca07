//! `Mesh`: the triangles of an OBJ or PLY file.

mod corner_tree;
mod obj;
mod other_file;
mod places;
mod ply;
mod ply_header;
mod ply_numbers;
mod polygon;
mod polygons;
mod sides;
mod vertex_normals;

use polygon::Triangulator;
use polygons::{Face, Polygons};
use vertex_normals::Smoothed;

/// The index of the normal of a corner without one.
pub(crate) const NONE: u32 = u32::MAX;

/// The bytes at the beginning of a text that say that it is UTF-8.
const BYTE_ORDER_MARK: &[u8] = b"\xEF\xBB\xBF";

/// Triangles that share corners and normals.
#[derive(Debug, Default)]
pub struct Mesh {
    /// The name of the file, as the scene file has it; empty if it is not known.
    pub(crate) file: String,
    corners: Vec<[f64; 3]>,
    normals: Vec<[f64; 3]>,
    /// For each corner of a triangle its index and that of its normal.
    triangles: Vec<[[u32; 2]; 3]>,
    /// What the reader of a scene should know about the faces.
    counts: Counts,
}

/// Numbers of faces that are drawn in another way than the file says.
#[derive(Clone, Copy, Debug, Default)]
struct Counts {
    /// Faces of one or two corners, or of none, which are left out.
    too_small: usize,
    /// Faces that name a normal that is missing or that is no direction.
    without_their_normal: usize,
    /// Triangles whose normals were to be computed.
    smoothed: Smoothed,
}

/// Three corners, and their normals if all have one.
pub type Triangle = ([[f64; 3]; 3], Option<[[f64; 3]; 3]>);

impl Mesh {
    /// Reads an OBJ or PLY file. Polygons become triangles; materials are ignored. The error is a
    /// clause.
    pub fn read(bytes: &[u8]) -> Result<Self, String> {
        let bytes = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
        if let Some(kind) = other_file::by_first_bytes(bytes) {
            return Err(is_other_file(kind));
        }
        let is_ply = ply_header::is_ply(bytes);
        let read = if is_ply {
            ply::read(bytes)
        } else {
            obj::read(bytes)
        };
        let format = if is_ply { "PLY" } else { "OBJ" };
        let in_format = |error| format!("a mistake in this {format}: {error}");
        let polygons = read.map_err(in_format)?;
        let count = polygons.positions.len();
        let mesh = Self::from_polygons(polygons).map_err(in_format)?;
        if !mesh.triangles.is_empty() {
            return Ok(mesh);
        }
        Err(if mesh.counts.too_small > 0 {
            "none of its faces has three corners".to_owned()
        } else if count > 0 {
            format!(
                "it has no faces, only {}, perhaps with lines between them; a mesh needs faces",
                number_of(count, "point")
            )
        } else if let Some(kind) = other_file::by_lines(bytes).filter(|_| !is_ply) {
            is_other_file(kind)
        } else {
            "it has no faces; a mesh is an OBJ file with lines such as f 1 2 3, or a PLY file"
                .to_owned()
        })
    }

    /// The polygons as triangles, in the order of the file. The error is a clause.
    fn from_polygons(polygons: Polygons) -> Result<Self, String> {
        polygons.check_corners()?;
        let mut mesh = Self {
            counts: Counts {
                too_small: polygons.too_small,
                ..Counts::default()
            },
            ..Self::default()
        };
        mesh.triangles.reserve(polygons.faces.len());
        let mut triangulator = Triangulator::default();
        let mut first = 0;
        let mut face = Vec::new();
        for Face { end, .. } in &polygons.faces {
            face.clear();
            let mut has_its_normals = true;
            for [corner, normal] in &polygons.corners[first..*end] {
                let named = polygons.normals.get(*normal as usize);
                let is_usable = named.is_some_and(|normal| is_direction(*normal));
                has_its_normals &= is_usable || *normal == NONE;
                face.push([*corner, if is_usable { *normal } else { NONE }]);
            }
            first = *end;
            mesh.counts.without_their_normal += usize::from(!has_its_normals);
            if let [a, b, c] = face[..] {
                mesh.triangles.push([a, b, c]);
                continue;
            }
            let points = face
                .iter()
                .map(|[corner, _]| polygons.positions[*corner as usize]);
            for triangle in triangulator.cut(points) {
                mesh.triangles
                    .push(triangle.map(|index| face[index as usize]));
            }
        }
        mesh.corners = polygons.positions;
        mesh.normals = polygons.normals;
        Ok(mesh)
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

    /// Makes all triangles smooth, with computed normals where the file has none, or all flat.
    pub fn set_smooth(&mut self, is_smooth: bool) {
        // What is said about normals that are missing is then said by the count of computed ones.
        self.counts.without_their_normal = 0;
        if is_smooth {
            self.counts.smoothed = self.add_missing_normals();
        } else {
            for corner in self.triangles.as_flattened_mut() {
                corner[1] = NONE;
            }
        }
    }

    /// What is drawn in another way than the file says, a clause for each kind.
    #[must_use]
    pub fn notes(&self) -> Vec<String> {
        let Counts {
            too_small,
            without_their_normal,
            smoothed,
        } = self.counts;
        let mut notes = Vec::new();
        if too_small > 0 {
            let faces = number_of(too_small, "face");
            let are = if too_small == 1 { "is" } else { "are" };
            notes.push(format!(
                "{faces} of fewer than three corners {are} left out"
            ));
        }
        if without_their_normal > 0 {
            let faces = number_of(without_their_normal, "face");
            let are = if without_their_normal == 1 {
                "is"
            } else {
                "are"
            };
            notes.push(format!(
                "{faces} {are} flat, with normals that are missing or have no direction"
            ));
        }
        let Smoothed { smooth, flat } = smoothed;
        if smooth > 0 {
            let count = self.triangles.len();
            notes.push(format!(
                "smooth, with computed normals for {smooth} of {}, for which the file has none",
                number_of(count, "triangle")
            ));
        }
        if flat > 0 {
            notes.push(format!(
                "flat in spite of smooth = true: {}, with no side in common with another to a \
                 thousandth of its length, or too narrow, or with normals that cancel out",
                number_of(flat, "triangle")
            ));
        }
        notes
    }
}

/// The error of a file of another kind.
fn is_other_file(kind: &str) -> String {
    // Where a mesh of this kind can be exported, the error names our kinds already.
    if kind.contains("OBJ") {
        format!("it is {kind}")
    } else {
        format!("it is {kind}; a mesh is an OBJ or PLY file")
    }
}

/// A count with its noun, such as `1 face` and `2 faces`.
fn number_of(count: usize, noun: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {noun}{plural}")
}

/// Whether a vector has finite coordinates, not all of them 0.
fn is_direction(vector: [f64; 3]) -> bool {
    vector.iter().all(|x| x.is_finite()) && vector != [0.0; 3]
}
