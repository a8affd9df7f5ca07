//! Where a group of shapes is cut in two.
//!
//! (Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007)

use super::bvh_build::Item;
use super::units::TreeBounds;

/// The most bins along an axis. Fewer shapes are put into as many bins as there are shapes.
const BINS: usize = 16;

/// Puts the shapes of the first kind before the others, and returns how many there are.
pub(super) fn by_kind(shapes: &mut [Item]) -> usize {
    shapes.sort_unstable_by_key(|item| item.shape.kind);
    shapes.partition_point(|item| item.shape.kind == shapes[0].shape.kind)
}

/// Puts the half of the shapes with the lower middles before the others, along the axis on
/// which the middles are spread farthest, and returns how many there are.
pub(super) fn halves(shapes: &mut [Item]) -> usize {
    let (middles, half) = (middles(shapes), shapes.len() / 2);
    let extent = |axis: &usize| middles.max[*axis] - middles.min[*axis];
    let axes = 0..3;
    let axis = axes
        .max_by(|a, b| extent(a).total_cmp(&extent(b)))
        .unwrap_or(0);
    let middle = |item: &Item| item.bounds.doubled_middle()[axis];
    shapes.select_nth_unstable_by(half, |a, b| middle(a).total_cmp(&middle(b)));
    half
}

/// Cuts the shapes so that the surface area heuristic expects the fewest tests, puts
/// those on the lower side before the others, and returns how many there are. None if all
/// middles are the same point.
pub(super) fn cheapest(shapes: &mut [Item]) -> Option<usize> {
    let binning = Binning::new(middles(shapes), shapes.len().min(BINS));
    let bins = binning.fill(shapes);
    let (_, axis, cut) = (0..3)
        .flat_map(|axis| {
            costs(&bins[axis][..binning.count]).map(move |(cost, cut)| (cost, axis, cut))
        })
        .min_by(|a, b| a.0.total_cmp(&b.0))?;
    let (mut left, mut right) = (0, shapes.len());
    while left < right {
        if binning.bins(&shapes[left])[axis] < cut {
            left += 1;
        } else {
            right -= 1;
            shapes.swap(left, right);
        }
    }
    Some(left)
}

/// Twice the middles of the shapes: their bounds.
fn middles(shapes: &[Item]) -> TreeBounds {
    shapes.iter().fold(TreeBounds::NOWHERE, |all, item| {
        let middle = item.bounds.doubled_middle();
        all.union(TreeBounds {
            min: middle,
            max: middle,
        })
    })
}

/// Shapes whose middles lie close together along an axis.
#[derive(Clone, Copy)]
struct Bin {
    count: u32,
    bounds: TreeBounds,
}

const EMPTY: Bin = Bin {
    count: 0,
    bounds: TreeBounds::NOWHERE,
};

impl Bin {
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

/// How middles are divided into bins.
struct Binning {
    count: usize,
    from: [f32; 3],
    per_unit: [f32; 3],
}

impl Binning {
    fn new(middles: TreeBounds, count: usize) -> Self {
        Self {
            count,
            from: middles.min,
            per_unit: std::array::from_fn(|axis| {
                let extent = middles.max[axis] - middles.min[axis];
                // All in the first bin, if there is no extent.
                if extent > 0.0 {
                    count as f32 / extent
                } else {
                    0.0
                }
            }),
        }
    }

    /// The bin of a shape along each axis.
    #[inline]
    fn bins(&self, item: &Item) -> [usize; 3] {
        let middle = item.bounds.doubled_middle();
        std::array::from_fn(|axis| {
            let place = (middle[axis] - self.from[axis]) * self.per_unit[axis];
            (place as usize).min(self.count - 1)
        })
    }

    fn fill(&self, shapes: &[Item]) -> [[Bin; BINS]; 3] {
        let mut all = [[EMPTY; BINS]; 3];
        for item in shapes {
            for (bins, bin) in all.iter_mut().zip(self.bins(item)) {
                let bin = &mut bins[bin];
                bin.count += 1;
                bin.bounds = bin.bounds.union(item.bounds);
            }
        }
        all
    }
}

/// The expected number of tests after each cut that leaves shapes on both sides, and the
/// first bin above it.
fn costs(bins: &[Bin]) -> impl Iterator<Item = (f32, usize)> {
    let mut above = [EMPTY; BINS];
    above[bins.len() - 1] = bins[bins.len() - 1];
    for bin in (1..bins.len() - 1).rev() {
        above[bin] = bins[bin].union(above[bin + 1]);
    }
    let mut below = EMPTY;
    (1..bins.len()).filter_map(move |cut| {
        below = below.union(bins[cut - 1]);
        let above = above[cut];
        (below.count > 0 && above.count > 0).then(|| (below.cost() + above.cost(), cut))
    })
}

#[cfg(test)]
pub(super) mod tests;
