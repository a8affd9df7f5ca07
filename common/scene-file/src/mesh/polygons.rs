//! `Polygons`: the points, normals and faces of a file, before the faces are triangles.

use std::collections::BTreeMap;
use std::fmt::Display;

use common::argument::MAX_LENGTH;
use common::text;

/// What a mesh file has.
#[derive(Debug, Default)]
pub struct Polygons {
    /// The format of the file, for errors.
    pub format: Format,
    /// The points.
    pub positions: Vec<[f64; 3]>,
    /// Points that are none, by their index, with the error of a face that has one.
    pub wrong_positions: BTreeMap<usize, String>,
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
    /// PLY: vertices are numbered from 0. This element has the faces.
    Ply {
        /// `face` or `tristrips`.
        element: &'static str,
    },
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

    /// Adds a point, with its place in words. One that is none, such as the NaN that a depth camera writes where it
    /// has seen nothing, is an error only if a face has it.
    pub fn add_position(&mut self, position: [f64; 3], place: impl Display) {
        for (axis, x) in ["x", "y", "z"].into_iter().zip(position) {
            let is_coordinate = x.abs() <= MAX_LENGTH;
            if !is_coordinate {
                let x = text::number(x);
                let error =
                    format!("{place} has the {axis} {x}, but a coordinate is from -1e100 to 1e100");
                self.wrong_positions.insert(self.positions.len(), error);
                self.positions.push([0.0; 3]);
                return;
            }
        }
        self.positions.push(position);
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
                        Format::Ply { .. } => index,
                    };
                    return Err(self.missing_corner(*place, &corner.to_string()));
                }
                if let Some(wrong) = self.wrong_positions.get(&index) {
                    return Err(wrong.clone());
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
            Format::Ply { element } => {
                format!("{element} {place} has the vertex {corner} of {count}, from 0")
            }
        }
    }
}
