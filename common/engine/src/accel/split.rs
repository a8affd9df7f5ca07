//! How a group of shapes is split in two.
//!
//! (Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007)

use super::ids::ShapeId;
use super::tree_space::TreeBounds;

/// A shape to be put into a tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Item {
    pub bounds: TreeBounds,
    pub shape: ShapeId,
}

/// The bounds of all items.
pub(super) fn bounds(items: &[Item]) -> TreeBounds {
    let all = items.iter().map(|item| item.bounds);
    all.fold(TreeBounds::EMPTY, TreeBounds::union)
}

/// Puts the shapes of the first kind before the others, and returns their number.
pub(super) fn by_kind(items: &mut [Item]) -> usize {
    items.sort_unstable_by_key(|item| item.shape.kind);
    items.partition_point(|item| item.shape.kind == items[0].shape.kind)
}

/// The median split along the axis on which the centroids have the largest extent: puts the lower
/// half before the others, and returns their number.
pub(super) fn at_median(items: &mut [Item]) -> usize {
    let (centroids, half) = (centroid_bounds(items), items.len() / 2);
    let extent = |axis: &usize| centroids.max[*axis] - centroids.min[*axis];
    let axes = 0..3;
    let axis = axes
        .max_by(|a, b| extent(a).total_cmp(&extent(b)))
        .unwrap_or(0);
    let centroid = |item: &Item| item.bounds.doubled_centroid()[axis];
    items.select_nth_unstable_by(half, |a, b| centroid(a).total_cmp(&centroid(b)));
    half
}

/// The split for which the surface area heuristic (SAH) expects the lowest cost: puts the shapes
/// on the lower side before the others, and returns their number. None if all centroids are the
/// same point.
pub(super) fn by_sah(items: &mut [Item]) -> Option<usize> {
    let binning = Binning::new(centroid_bounds(items), items.len().min(BINS));
    let bins = binning.fill(items);
    let mut best: Option<(f32, usize, usize)> = None;
    for (axis, bins) in bins.iter().enumerate() {
        for (cost, split) in costs(&bins[..binning.count]) {
            if best.is_none_or(|(least, ..)| cost.total_cmp(&least).is_lt()) {
                best = Some((cost, axis, split));
            }
        }
    }
    let (_, axis, split) = best?;
    let (mut left, mut right) = (0, items.len());
    while left < right {
        if binning.bin(&items[left], axis) < split {
            left += 1;
        } else {
            right -= 1;
            items.swap(left, right);
        }
    }
    Some(left)
}

/// The bounds of twice the centroids.
fn centroid_bounds(items: &[Item]) -> TreeBounds {
    items.iter().fold(TreeBounds::EMPTY, |all, item| {
        let centroid = item.bounds.doubled_centroid();
        all.union(TreeBounds {
            min: centroid,
            max: centroid,
        })
    })
}

/// The most bins along an axis. Fewer shapes have one bin each.
const BINS: usize = 16;

/// Shapes whose centroids lie close together along an axis.
#[derive(Clone, Copy)]
struct Bin {
    count: u32,
    bounds: TreeBounds,
}

impl Bin {
    const EMPTY: Self = Self {
        count: 0,
        bounds: TreeBounds::EMPTY,
    };

    fn union(self, other: Self) -> Self {
        Self {
            count: self.count + other.count,
            bounds: self.bounds.union(other.bounds),
        }
    }

    /// The expected number of tests.
    fn cost(&self) -> f32 {
        self.count as f32 * self.bounds.half_area()
    }
}

/// Equal bins between the extreme centroids along each axis.
struct Binning {
    count: usize,
    origin: [f32; 3],
    bins_per_length: [f32; 3],
}

impl Binning {
    fn new(centroids: TreeBounds, count: usize) -> Self {
        Self {
            count,
            origin: centroids.min,
            bins_per_length: std::array::from_fn(|axis| {
                let extent = centroids.max[axis] - centroids.min[axis];
                // All in the first bin, if there is no extent.
                if extent > 0.0 {
                    count as f32 / extent
                } else {
                    0.0
                }
            }),
        }
    }

    /// The bin of a shape along an axis.
    #[inline]
    fn bin(&self, item: &Item, axis: usize) -> usize {
        let centroid = item.bounds.doubled_centroid()[axis];
        let bin = (centroid - self.origin[axis]) * self.bins_per_length[axis];
        (bin as usize).min(self.count - 1)
    }

    fn fill(&self, items: &[Item]) -> [[Bin; BINS]; 3] {
        let mut all = [[Bin::EMPTY; BINS]; 3];
        for item in items {
            for (axis, bins) in all.iter_mut().enumerate() {
                let bin = &mut bins[self.bin(item, axis)];
                bin.count += 1;
                bin.bounds = bin.bounds.union(item.bounds);
            }
        }
        all
    }
}

/// The cost of each split that leaves shapes on both sides, and the first bin above it.
fn costs(bins: &[Bin]) -> impl Iterator<Item = (f32, usize)> {
    let mut above = [Bin::EMPTY; BINS];
    above[bins.len() - 1] = bins[bins.len() - 1];
    for bin in (1..bins.len() - 1).rev() {
        above[bin] = bins[bin].union(above[bin + 1]);
    }
    let mut below = Bin::EMPTY;
    (1..bins.len()).filter_map(move |split| {
        below = below.union(bins[split - 1]);
        let above = above[split];
        (below.count > 0 && above.count > 0).then(|| (below.cost() + above.cost(), split))
    })
}

#[cfg(test)]
pub(super) mod tests;
