//! `CornerTree`: finds the corners near a place, in whatever surface they lie.
//!
//! (Bentley, Multidimensional Binary Search Trees Used for Associative Searching, 1975.)

use glam::DVec3;

/// Subtrees of at most this many corners are not split.
const LEAF: usize = 8;

/// Corners in the order of a balanced tree: the middle one splits those before it from those
/// behind it, along the axis of their greatest extent.
pub(super) struct CornerTree<'a> {
    positions: &'a [[f64; 3]],
    corners: Vec<u32>,
    /// The axis along which the corner at each index splits.
    axes: Vec<u8>,
}

impl<'a> CornerTree<'a> {
    /// The tree of some corners, which have these positions.
    pub fn new(positions: &'a [[f64; 3]], corners: Vec<u32>) -> Self {
        let mut tree = Self {
            positions,
            axes: vec![0; corners.len()],
            corners,
        };
        tree.split(0, tree.corners.len());
        tree
    }

    fn split(&mut self, from: usize, to: usize) {
        if to - from <= LEAF {
            return;
        }
        let (corners, positions) = (&mut self.corners[from..to], self.positions);
        let at = |corner: u32| positions[corner as usize];
        let (mut min, mut max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for corner in &*corners {
            min = min.min(at(*corner).into());
            max = max.max(at(*corner).into());
        }
        let axis = (max - min).max_position();
        let middle = corners.len() / 2;
        corners.select_nth_unstable_by(middle, |a, b| at(*a)[axis].total_cmp(&at(*b)[axis]));
        let middle = from + middle;
        self.axes[middle] = axis as u8;
        self.split(from, middle);
        self.split(middle + 1, to);
    }

    /// Passes on at least the corners within this distance of a place, in any order.
    pub fn for_each_near(&self, place: [f64; 3], reach: f64, each: &mut impl FnMut(u32)) {
        self.visit(0, self.corners.len(), place, reach, each);
    }

    fn visit(
        &self,
        from: usize,
        to: usize,
        place: [f64; 3],
        reach: f64,
        each: &mut impl FnMut(u32),
    ) {
        if to - from <= LEAF {
            return self.corners[from..to].iter().copied().for_each(each);
        }
        let middle = from + (to - from) / 2;
        let axis = usize::from(self.axes[middle]);
        let corner = self.corners[middle];
        let beyond = place[axis] - self.positions[corner as usize][axis];
        each(corner);
        if beyond <= reach {
            self.visit(from, middle, place, reach, each);
        }
        if -beyond <= reach {
            self.visit(middle + 1, to, place, reach, each);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Corners of a tilted grid, each of them twice, and of a line across it.
    #[test]
    fn corners_near_a_place_are_found() {
        let mut corners = Vec::new();
        for i in 0..400 {
            let (row, column) = (f64::from(i / 20), f64::from(i % 20));
            corners.extend([[row, column, row - column]; 2]);
            corners.push([-0.0, 0.0, f64::from(i) / 16.0]);
        }
        let all: Vec<_> = (0..corners.len() as u32).collect();
        let tree = CornerTree::new(&corners, all.clone());
        for (place, reach) in corners.iter().zip([0.0, 0.5, 3.0].into_iter().cycle()) {
            let is_near = |corner: &u32| {
                let at = DVec3::from(corners[*corner as usize]);
                at.distance(DVec3::from(*place)) <= reach
            };
            let mut found = Vec::new();
            tree.for_each_near(*place, reach, &mut |corner| found.push(corner));
            found.retain(is_near);
            found.sort_unstable();
            let near: Vec<_> = all.iter().copied().filter(is_near).collect();
            assert_eq!(found, near);
        }
    }
}
