//! `Accelerator`: finds the shapes that a ray can hit, without testing all of them.
//!
//! Every candidate is tested with its own formula, and only shapes are skipped that
//! the ray cannot hit. So the result has the bits of a test of all shapes.

mod bundle;
mod bvh;
mod bvh_build;
mod cut;
mod list;
mod nearest;
mod search;
mod shadow;
mod shapes;
mod single;
mod slabs;
mod units;

use crate::shape::Bounds;
pub(crate) use bundle::SEARCHES;
use bvh::{Bvh, Leaf};
use bvh_build::Item;
pub(crate) use nearest::{NearestHits, NearestSearch};
pub(crate) use shadow::{Occluder, ShadowSearch};
use shapes::ShapeId;
pub(crate) use shapes::Shapes;
use units::Units;

/// Up to this many shapes are few: one ray sooner tests them than it searches for them.
const FEW: usize = 16;

/// The shapes of a scene, prepared for many rays.
#[derive(Debug)]
pub(crate) struct Accelerator<'a> {
    pub shapes: Shapes<'a>,
    /// The shapes without finite bounds, which every ray is tested against.
    unbounded: Vec<Leaf>,
    /// The others.
    tree: Option<Bvh>,
    /// All shapes, if they are few; otherwise none.
    few: Vec<Leaf>,
}

impl<'a> Accelerator<'a> {
    /// The accelerator of these shapes.
    pub fn new(mut shapes: Shapes<'a>) -> Self {
        shapes.finish();
        let (mut all, mut unbounded) = (Bounds::NOWHERE, Vec::new());
        let mut depth_error = 0.0;
        for (shape, bounds) in shapes.bounds() {
            if bounds.are_finite() {
                all = all.union(bounds);
                depth_error += shapes.depth_error(shape);
            } else {
                unbounded.push(shape);
            }
        }
        let count = shapes.len() - unbounded.len();
        // A tree that expects larger errors looks into bounds behind the nearest hit. So it
        // expects the mean of all shapes; bounds of those with larger ones are widened.
        let units = Units::new(
            all,
            depth_error / count.max(1) as f64,
            shapes.triangles.places.is_empty(),
        );
        let mut items = Vec::with_capacity(count);
        let bounded = shapes.bounds().filter(|(_, bounds)| bounds.are_finite());
        items.extend(bounded.map(|(shape, bounds)| Item {
            bounds: units.bounds(bounds, shapes.depth_error(shape)),
            shape,
        }));
        let name = |items: &mut [Item]| {
            let bounded = items.iter_mut().map(|item| &mut item.shape);
            shapes.reorder(bounded.chain(&mut unbounded));
        };
        let tree = if items.is_empty() {
            None
        } else {
            Some(Bvh::new(units, items, name))
        };
        let few = if shapes.len() <= FEW {
            leaves(shapes.ids())
        } else {
            Vec::new()
        };
        Self {
            unbounded: leaves(unbounded),
            tree,
            few,
            shapes,
        }
    }
}

/// Shapes of consecutive names, in as few leaves as possible.
fn leaves(shapes: impl IntoIterator<Item = ShapeId>) -> Vec<Leaf> {
    let shapes: Vec<_> = shapes.into_iter().collect();
    let runs = shapes.chunk_by(|a, b| a.kind == b.kind);
    let fours = runs.flat_map(|run| run.chunks(run[0].kind.most_in_leaf()));
    let leaf = |four: &[ShapeId]| Leaf {
        kind: four[0].kind,
        count: four.len() as u8,
        first: four[0].index,
    };
    fours.map(leaf).collect()
}
