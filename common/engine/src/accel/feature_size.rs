//! Whether an object between four rays is narrow enough to be missed by all of them.

use super::RayBundle;
use super::grid::PerspectiveGrid;
use crate::Ray;

impl PerspectiveGrid {
    /// Whether a single shape narrower than `feature_size` times the side could appear
    /// between four rays through the bundle's point, the corners of a square. None if
    /// the rays do not belong to the bundle.
    pub fn may_miss_features(&self, corners: &[Ray; 4], feature_size: f64) -> Option<bool> {
        let RayBundle::Through(point) = self.bundle else {
            return None;
        };
        if corners.iter().any(|ray| ray.origin != point) {
            return None;
        }
        let (from, to) = self.extent_of(&corners.map(|ray| ray.direction))?;
        let narrow = feature_size * (to[0] - from[0]).max(to[1] - from[1]);
        let is_beside = |axis: usize| {
            let end = self.from[axis] + self.side as f64 / self.per_unit[axis];
            to[axis] < self.from[axis] || from[axis] > end
        };
        if is_beside(0) || is_beside(1) {
            return Some(false);
        }
        let mut cells = self.cells((from, to));
        Some(cells.any(|cell| f64::from(self.feature_sizes[cell]) < narrow))
    }
}

#[cfg(test)]
mod tests;
