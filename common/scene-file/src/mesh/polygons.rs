//! `Polygons`: the points, normals and faces of a file, before the faces are triangles.

use common::argument::MAX_LENGTH;
use common::text;

/// What a mesh file has.
#[derive(Debug, Default)]
pub struct Polygons {
    /// The format of the file, for errors.
    pub format: Format,
    /// The points.
    pub positions: Vec<[f64; 3]>,
    /// The normals, of any length; NaN where the file has no numbers for them.
    pub normals: Vec<[f64; 3]>,
    /// The corners of all faces, one face after the other: the index of the point, and that of
    /// the normal or [`super::NONE`]. They may be too large.
    pub corners: Vec<[u32; 2]>,
    /// The faces of three corners or more.
    pub faces: Vec<Face>,
    /// The number of faces of fewer corners.
    pub too_small: usize,
}

/// A face, whose corners begin where those of the face before it end.
#[derive(Clone, Copy, Debug)]
pub struct Face {
    /// The number of corners of all faces up to this one.
    pub end: usize,
    /// Where it is: its line, or its number.
    pub place: usize,
}

/// The format of a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Format {
    /// Wavefront OBJ: corners are numbered from 1.
    #[default]
    Obj,
    /// PLY: vertices are numbered from 0.
    Ply,
}

impl Polygons {
    /// Ends the face of the corners after the last face.
    pub fn end_face(&mut self, place: usize) {
        let first = self.faces.last().map_or(0, |face| face.end);
        let end = self.corners.len();
        if end - first < 3 {
            self.corners.truncate(first);
            self.too_small += 1;
        } else {
            self.faces.push(Face { end, place });
        }
    }

    /// Adds a point. The error is the end of a sentence about it.
    pub fn add_position(&mut self, position: [f64; 3]) -> Result<(), String> {
        for (axis, x) in ["x", "y", "z"].into_iter().zip(position) {
            let is_coordinate = x.abs() <= MAX_LENGTH;
            if !is_coordinate {
                let x = text::number(x);
                return Err(format!(
                    "has the {axis} {x}, but a coordinate is from -1e100 to 1e100"
                ));
            }
        }
        self.positions.push(position);
        Ok(())
    }

    /// Checks that each corner of a face is a point. The error is a clause.
    pub fn check_corners(&self) -> Result<(), String> {
        let mut first = 0;
        for Face { end, place } in &self.faces {
            for [corner, _] in &self.corners[first..*end] {
                let index = *corner as usize;
                if index >= self.positions.len() {
                    let corner = match self.format {
                        Format::Obj => index + 1,
                        Format::Ply => index,
                    };
                    return Err(self.missing_corner(*place, &corner.to_string()));
                }
            }
            first = *end;
        }
        Ok(())
    }

    /// The error of a face with a corner that is not in the file.
    pub fn missing_corner(&self, place: usize, corner: &str) -> String {
        let count = self.positions.len();
        match self.format {
            Format::Obj => {
                format!("the face in line {place} has the corner {corner} of {count}, from 1")
            }
            Format::Ply => format!("face {place} has the vertex {corner} of {count}, from 0"),
        }
    }
}
