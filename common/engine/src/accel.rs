//! `Accelerator`: finds the shapes that a ray can hit, without testing all of them.
//!
//! Every candidate is tested with its own formula, and only shapes are skipped that
//! the ray cannot hit. So the result is bit-identical to that of a linear scan.

mod bvh;
mod bvh_build;
mod cut;
mod list;
mod packet;
mod shapes;
mod single;
mod slabs;
mod units;

use common::Plan;

use crate::shape::Bounds;
use bvh::{Bvh, Leaf};
use bvh_build::Item;
pub(crate) use packet::{NearestHits, Occluder};
use shapes::ShapeId;
pub(crate) use shapes::Shapes;
use units::Units;

/// Up to this many shapes are all tested.
const FEW: usize = 16;

/// The shapes of a scene, prepared for many rays.
#[derive(Debug)]
pub(crate) struct Accelerator<'a> {
    pub shapes: Shapes<'a>,
    /// The shapes that every ray is tested against: those without finite bounds, or all, if
    /// they are few.
    scanned: Vec<Leaf>,
    /// The others.
    tree: Option<Bvh>,
}

impl<'a> Accelerator<'a> {
    /// The accelerator of these shapes.
    pub fn new(mut shapes: Shapes<'a>) -> Self {
        shapes.finish();
        let is_few = shapes.len() <= FEW;
        let is_scanned = |bounds: Bounds| is_few || !bounds.are_finite();
        let (mut all, mut scanned) = (Bounds::NOWHERE, Vec::new());
        let mut depth_error = 0.0;
        for (shape, bounds) in shapes.bounds() {
            if is_scanned(bounds) {
                scanned.push(shape);
            } else {
                all = all.union(bounds);
                depth_error += shapes.depth_error(shape);
            }
        }
        let count = shapes.len() - scanned.len();
        // A tree that expects larger errors looks into bounds behind the nearest hit. So it
        // expects the mean of all shapes; bounds of those with larger ones are widened.
        let units = Units::new(
            all,
            depth_error / count.max(1) as f64,
            shapes.triangles.places.is_empty(),
        );
        let mut items = Vec::with_capacity(count);
        let in_tree = shapes.bounds().filter(|(_, bounds)| !is_scanned(*bounds));
        items.extend(in_tree.map(|(shape, bounds)| Item {
            bounds: units.bounds(bounds, shapes.depth_error(shape)),
            shape,
        }));
        let name = |items: &mut [Item]| {
            let in_tree = items.iter_mut().map(|item| &mut item.shape);
            shapes.reorder(in_tree.chain(&mut scanned));
        };
        let tree = if items.is_empty() {
            None
        } else {
            Some(Bvh::new(units, items, name))
        };
        Self {
            scanned: leaves(&scanned),
            shapes,
            tree,
        }
    }

    /// Adds to a plan the tests that are skipped.
    pub fn plan(&self, plan: Plan) -> Plan {
        if self.tree.is_none() {
            return plan;
        }
        plan.without(
            "tests of objects far from a ray",
            "a bounding volume hierarchy finds the objects near it",
        )
    }
}

/// Shapes that are named in turn, as few leaves.
fn leaves(shapes: &[ShapeId]) -> Vec<Leaf> {
    let runs = shapes.chunk_by(|a, b| a.kind == b.kind);
    let fours = runs.flat_map(|run| run.chunks(run[0].kind.most_in_leaf()));
    let leaf = |four: &[ShapeId]| Leaf {
        kind: four[0].kind,
        count: four.len() as u8,
        first: four[0].index,
    };
    fours.map(leaf).collect()
}
