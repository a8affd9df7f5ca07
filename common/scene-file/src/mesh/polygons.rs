//! `Polygons`: the points, normals and faces of a file, before the faces are triangles.

use common::argument::LARGEST_LENGTH;
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
    /// Points that are no points, by their index, and where they are: a line.
    pub wrong_positions: Vec<(usize, usize)>,
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

    /// Adds a point, which is at this line of an OBJ file.
    pub fn add_position(&mut self, position: [f64; 3], line: usize) {
        if !position.into_iter().all(is_coordinate) {
            self.wrong_positions.push((self.positions.len(), line));
        }
        self.positions.push(position);
    }

    /// Checks that each corner of a face is a point. The error is a clause.
    pub fn check_corners(&self) -> Result<(), String> {
        let count = self.positions.len();
        let mut faces = self.faces.iter();
        let mut face = faces.next();
        for (i, [corner, _]) in self.corners.iter().enumerate() {
            while let Some(Face { end, .. }) = face
                && *end <= i
            {
                face = faces.next();
            }
            let place = face.map_or(0, |face| face.place);
            let index = *corner as usize;
            let Some(position) = self.positions.get(index) else {
                return Err(self.missing_corner(place, &self.name_of_corner(index), count));
            };
            if let Some(wrong) = position.iter().position(|x| !is_coordinate(*x)) {
                return Err(self.wrong_position(index, wrong, position[wrong]));
            }
        }
        Ok(())
    }

    /// The error of a face with a corner that is not in the file.
    pub fn missing_corner(&self, place: usize, corner: &str, count: usize) -> String {
        let face = self.name_of_face(place);
        match self.format {
            Format::Obj => format!("{face} has the corner {corner} of {count}, from 1"),
            Format::Ply { .. } => format!("{face} has the vertex {corner} of {count}, from 0"),
        }
    }

    /// The error of a point whose coordinate of this number is no coordinate.
    fn wrong_position(&self, index: usize, axis: usize, value: f64) -> String {
        let axis = ["x", "y", "z"][axis];
        let found = self
            .wrong_positions
            .iter()
            .find(|(wrong, _)| *wrong == index);
        let place = match (self.format, found) {
            (Format::Obj, Some((_, line))) => format!("line {line}"),
            (Format::Obj, None) => format!("corner {}", index + 1),
            (Format::Ply { .. }, _) => format!("vertex {index}"),
        };
        let value = text::number(value);
        format!("{place} has the {axis} {value}, but a coordinate is from -1e100 to 1e100")
    }

    /// A face in words, by its line or its number.
    pub fn name_of_face(&self, place: usize) -> String {
        match self.format {
            Format::Obj => format!("the face in line {place}"),
            Format::Ply { element } => format!("{element} {place}"),
        }
    }

    fn name_of_corner(&self, index: usize) -> String {
        match self.format {
            Format::Obj => (index + 1).to_string(),
            Format::Ply { .. } => index.to_string(),
        }
    }
}

fn is_coordinate(x: f64) -> bool {
    x.abs() <= LARGEST_LENGTH
}
