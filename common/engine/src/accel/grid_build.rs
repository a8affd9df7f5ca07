//! How a [`PerspectiveGrid`] is built.

use glam::DVec3;

use super::RayBundle;
use super::grid::{Candidate, Extent, PerspectiveGrid};
use super::shapes::ShapeId;
use crate::shape::Bounds;
use crate::vector::{largest_coordinate, normalized};

/// Bounds are widened by this share of the largest coordinate: more than the distance by
/// which rounding moves a hit, and by which the origin of a ray that leaves a surface
/// is offset.
const SLACK: f64 = 1.0 / (1_u64 << 30) as f64;
/// Cells with more candidates than this are crowded, as in a mesh: rays that miss one
/// shape hit another.
const CROWDED: usize = 3;
/// Rays may start this many times farther out than the shapes and the bundle's point.
const MAX_ORIGIN: f64 = 16_384.0;

impl PerspectiveGrid {
    /// The cells of these shapes, which have finite bounds. None if they do not all
    /// lie on one side of the bundle's point.
    pub fn new(bundle: RayBundle, shapes: &[(Bounds, ShapeId)]) -> Option<Self> {
        let all = Bounds::of_all(shapes.iter().map(|(bounds, _)| *bounds));
        let (gaze, at) = match bundle {
            RayBundle::Through(point) => {
                (DVec3::from(all.middle()) - point, largest_coordinate(point))
            }
            RayBundle::Parallel(direction) => (direction, 0.0),
        };
        let gaze = normalized(gaze)?;
        let corners = all.corners().map(largest_coordinate);
        let largest = corners.into_iter().fold(at, f64::max);
        let right = gaze.any_orthonormal_vector();
        let mut grid = Self {
            bundle,
            right,
            up: gaze.cross(right),
            gaze,
            from: [0.0; 2],
            per_unit: [0.0; 2],
            side: 0,
            per_length: 1.0 / largest,
            tolerance: largest * SLACK / 2.0,
            max_origin: largest * MAX_ORIGIN,
            starts: Vec::new(),
            candidates: Vec::new(),
            feature_sizes: Vec::new(),
        };

        let seen = |(bounds, shape): &(Bounds, ShapeId)| {
            let bounds = bounds.wider(largest * SLACK);
            let candidate = Candidate {
                near: grid.nearest(bounds),
                shape: *shape,
            };
            Some((candidate, grid.extent_of_bounds(bounds)?))
        };
        let mut seen: Vec<_> = shapes.iter().map(seen).collect::<Option<_>>()?;
        // The nearest candidates come first, so that a search can end early.
        seen.sort_by(|(a, _), (b, _)| a.near.total_cmp(&b.near));
        grid.choose_cells(&seen)?;
        grid.fill(&seen);
        Some(grid)
    }

    /// The least distance of bounds from the bundle's point, or along its direction.
    fn nearest(&self, bounds: Bounds) -> f32 {
        let near = match self.bundle {
            RayBundle::Through(point) => {
                let inside = point.clamp(bounds.min.into(), bounds.max.into());
                (inside - point).length()
            }
            RayBundle::Parallel(_) => {
                let depths = bounds.corners().map(|corner| corner.dot(self.gaze));
                depths.into_iter().fold(f64::INFINITY, f64::min)
            }
        };
        ((near - near.abs() / 1e6) * self.per_length) as f32
    }

    /// Chooses the number of cells and counts the candidates of each: about sixteen
    /// cells a shape, but fewer where shapes fill many.
    fn choose_cells(&mut self, seen: &[(Candidate, Extent)]) -> Option<()> {
        self.from = [0, 1].map(|axis| {
            let from = seen.iter().map(|(_, (from, _))| from[axis]);
            from.fold(f64::INFINITY, f64::min)
        });
        let size = [0, 1].map(|axis| {
            let to = seen.iter().map(|(_, (_, to))| to[axis]);
            to.fold(f64::NEG_INFINITY, f64::max) - self.from[axis]
        });
        self.side = (4.0 * (seen.len() as f64).sqrt()).clamp(64.0, 1024.0) as usize;
        loop {
            self.per_unit = size.map(|size| self.side as f64 / size);
            if !self.per_unit.iter().all(|per_unit| per_unit.is_finite()) {
                return None;
            }
            self.starts = vec![0; self.side * self.side + 1];
            let mut total = 0;
            for (_, extent) in seen {
                for cell in self.cells(*extent) {
                    self.starts[cell + 1] += 1;
                    total += 1;
                }
            }
            if total <= 16 * (seen.len() + 4096) {
                return Some(());
            }
            self.side /= 2;
        }
    }

    /// Enters each shape into all cells in which it appears.
    fn fill(&mut self, seen: &[(Candidate, Extent)]) {
        for cell in 1..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }
        let end = self.starts[self.side * self.side];
        self.starts.push(end);
        let nothing = Candidate {
            near: 0.0,
            shape: ShapeId::Other(u32::MAX),
        };
        self.candidates = vec![nothing; end as usize];
        let mut next = self.starts.clone();
        self.feature_sizes = vec![f32::INFINITY; self.side * self.side];
        for (candidate, extent) in seen {
            let (from, to) = extent;
            // Only a sphere is as wide as its bounds from every side.
            let width = match candidate.shape {
                ShapeId::Sphere(_) => (to[0] - from[0]).min(to[1] - from[1]) as f32,
                _ => 0.0,
            };
            for cell in self.cells(*extent) {
                self.candidates[next[cell] as usize] = *candidate;
                next[cell] += 1;
                self.feature_sizes[cell] = self.feature_sizes[cell].min(width);
            }
        }
        for cell in 0..self.feature_sizes.len() {
            if self.candidates_of(cell).len() > CROWDED {
                self.feature_sizes[cell] = f32::INFINITY;
            }
        }
    }
}

#[cfg(test)]
mod tests;
