//! `Accelerator`: finds the shapes that a ray can hit, without testing all of them.
//!
//! Every candidate is tested with its own formula, and only shapes are skipped that
//! the ray cannot hit. So the result has the bits of a test of all shapes.

mod bvh;
mod bvh_build;
mod ids;
mod nearest;
mod packet_culling;
mod query;
mod shadow;
mod shape_list;
mod shapes;
mod slabs;
mod split;
mod traverse;
mod tree_space;

use crate::shape::Bounds;
use bvh::Bvh;
pub(crate) use ids::Kind;
use ids::Leaf;
pub(crate) use ids::ShapeId;
pub(crate) use nearest::NearestHits;
pub(crate) use packet_culling::PACKETS;
pub(crate) use query::Query;
pub(crate) use shadow::Occluder;
pub(crate) use shapes::Shapes;
use split::Item;
use tree_space::TreeSpace;

/// A linear scan of a few packets is faster up to this number of shapes, none of which is an instance.
const LINEAR_SCAN_SHAPES: usize = 16;

/// The shapes of a scene, prepared for many rays.
pub(crate) struct Accelerator<'a> {
    pub shapes: Shapes<'a>,
    /// The shapes with finite bounds.
    tree: Option<Bvh>,
    /// The others, which every ray is tested against.
    unbounded: Vec<Leaf>,
    /// All shapes, if a linear scan may be faster; otherwise none.
    linear_scan: Vec<Leaf>,
}

impl<'a> Accelerator<'a> {
    /// The accelerator of these shapes.
    pub fn new(mut shapes: Shapes<'a>) -> Self {
        let (tree, unbounded) = build(&mut shapes);
        let is_linear = shapes.len() <= LINEAR_SCAN_SHAPES && !shapes.have_instances();
        let ids: Vec<_> = shapes.ids().filter(|_| is_linear).collect();
        Self {
            tree,
            unbounded: Leaf::of_all(&unbounded),
            linear_scan: Leaf::of_all(&ids),
            shapes,
        }
    }

    /// An accelerator that tests each of these shapes, to measure what the tree saves.
    pub fn without_tree(shapes: Shapes<'a>) -> Self {
        let ids: Vec<_> = shapes.ids().collect();
        Self {
            tree: None,
            unbounded: Leaf::of_all(&ids),
            linear_scan: Vec::new(),
            shapes,
        }
    }
}

/// The tree of the shapes with finite bounds, and the other shapes. Sorts the shapes in the order
/// of the leaves.
fn build(shapes: &mut Shapes) -> (Option<Bvh>, Vec<ShapeId>) {
    let (mut all, mut depth_error) = (Bounds::EMPTY, 0.0);
    let (mut bounded, mut unbounded) = (0_u32, Vec::new());
    for (shape, bounds) in shapes.bounds() {
        if bounds.are_finite() {
            all = all.union(bounds);
            depth_error += shapes.depth_error(shape);
            bounded += 1;
        } else {
            unbounded.push(shape);
        }
    }
    if bounded == 0 {
        return (None, unbounded);
    }
    // A tree that expects larger errors looks into bounds behind the nearest hit. So it
    // expects the mean of all shapes; bounds of those with larger ones are widened.
    let is_exact = shapes.triangles.attributes.is_empty();
    let space = TreeSpace::new(all, depth_error / f64::from(bounded), is_exact);
    let mut items = Vec::with_capacity(bounded as usize);
    let finite = shapes.bounds().filter(|(_, bounds)| bounds.are_finite());
    items.extend(finite.map(|(shape, bounds)| Item {
        bounds: space.bounds(bounds, shapes.depth_error(shape)),
        shape,
    }));
    let tree = Bvh::new(space, items, |items| {
        let bounded = items.iter_mut().map(|item| &mut item.shape);
        shapes.reorder(bounded.chain(&mut unbounded));
    });
    (Some(tree), unbounded)
}
