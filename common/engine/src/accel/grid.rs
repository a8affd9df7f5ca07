//! `PerspectiveGrid`: the shapes in each direction from a point, or along parallel
//! rays.
//!
//! Most rays of a picture belong to a bundle: those from the eye, and those to each
//! light. Seen from its point, space is divided into cells like the pixels of a
//! picture, and each cell lists the shapes that appear in it.
//!
//! (For eyes: the item buffer of Weghorst, Hooper and Greenberg, Improved
//! Computational Methods for Ray Tracing, 1984; for lights: the light buffer of Haines
//! and Greenberg, 1986; the name: Hunt and Mark, Ray-Specialized Acceleration
//! Structures for Ray Tracing, 2008.)

use glam::DVec3;

use super::RayBundle;
use super::shapes::ShapeId;
use crate::shape::Bounds;

/// The cells of a bundle.
#[derive(Debug)]
pub(super) struct PerspectiveGrid {
    pub bundle: RayBundle,
    /// The axes of the grid: to the right, up, and away from the point.
    pub right: DVec3,
    pub up: DVec3,
    pub gaze: DVec3,
    /// The lower left corner of the first cell, and cells per unit.
    pub from: [f64; 2],
    pub per_unit: [f64; 2],
    /// Cells in a row and in a column.
    pub side: usize,
    /// Factor from lengths to the unit of the grid, in which all coordinates are up
    /// to 1.
    pub per_length: f64,
    /// Largest distance at which a ray may pass the point of the bundle.
    pub tolerance: f64,
    /// The largest coordinate that a ray may start at.
    pub max_origin: f64,
    /// The index of the first candidate of each cell; the last cell is an extra, empty
    /// one.
    pub starts: Vec<u32>,
    pub candidates: Vec<Candidate>,
    /// The size of the narrowest object in each cell, unless many lie there together.
    pub feature_sizes: Vec<f32>,
}

/// A shape in a cell.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate {
    /// Lower bound of the distance of the shape from the point of the bundle, or along
    /// its direction, in the unit of the grid.
    pub near: f32,
    pub shape: ShapeId,
}

/// The places in the grid between which a shape appears.
pub(super) type Extent = ([f64; 2], [f64; 2]);

impl PerspectiveGrid {
    /// The cells between two places.
    pub fn cells(&self, (from, to): Extent) -> impl Iterator<Item = usize> + use<> {
        let side = self.side;
        let cell = |place: [f64; 2]| {
            [0, 1].map(|axis| {
                let cell = (place[axis] - self.from[axis]) * self.per_unit[axis];
                (cell as usize).min(side - 1)
            })
        };
        let ([left, low], [right, high]) = (cell(from), cell(to));
        (low..=high).flat_map(move |y| (left..=right).map(move |x| y * side + x))
    }

    /// The place of a point in the grid. None beside and behind the point of the
    /// bundle.
    #[inline]
    pub fn place(&self, p: DVec3) -> Option<[f64; 2]> {
        let (x, y) = (p.dot(self.right), p.dot(self.up));
        match self.bundle {
            RayBundle::Through(_) => {
                let depth = p.dot(self.gaze);
                (depth > 0.0).then(|| [x / depth, y / depth])
            }
            RayBundle::Parallel(_) => Some([x, y]),
        }
    }

    /// A point relative to the point of the bundle.
    #[inline]
    pub fn relative(&self, p: DVec3) -> DVec3 {
        match self.bundle {
            RayBundle::Through(point) => p - point,
            RayBundle::Parallel(_) => p,
        }
    }

    /// The extent of some points.
    pub fn extent_of(&self, points: &[DVec3]) -> Option<Extent> {
        let (mut from, mut to) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in points {
            let place = self.place(*point)?;
            for axis in 0..2 {
                from[axis] = from[axis].min(place[axis]);
                to[axis] = to[axis].max(place[axis]);
            }
        }
        Some((from, to))
    }

    /// The extent of bounds. None if they are not well in front.
    pub fn extent_of_bounds(&self, bounds: Bounds) -> Option<Extent> {
        let points = bounds.corners().map(|corner| self.relative(corner));
        // Beyond some 80 degrees the cells would be too unequal.
        let is_aside = |p: &DVec3| p.dot(self.gaze) < 0.15 * p.length();
        if matches!(self.bundle, RayBundle::Through(_)) && points.iter().any(is_aside) {
            return None;
        }
        self.extent_of(&points)
    }

    /// The candidates of a cell.
    #[inline]
    pub fn candidates_of(&self, cell: usize) -> &[Candidate] {
        &self.candidates[self.starts[cell] as usize..self.starts[cell + 1] as usize]
    }
}
