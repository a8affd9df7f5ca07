//! `Accelerator`: finds the shapes that a ray can hit, without testing all of them.
//!
//! Every candidate is tested with its own formula, and only shapes are skipped that
//! the ray cannot hit. So the result is bit-identical to that of a linear scan.

mod bvh;
mod bvh_build;
mod feature_size;
mod grid;
mod grid_build;
mod grid_lookup;
mod packet;
mod shapes;
mod single;
mod trees;

use std::sync::OnceLock;

use common::Plan;
use glam::DVec3;

use crate::Ray;
pub(crate) use bvh::WIDTH;
use grid::PerspectiveGrid;
pub(crate) use packet::NearestHits;
use shapes::ShapeId;
pub(crate) use shapes::Shapes;
use trees::{FEW, Trees};

/// Up to this many shapes a linear scan is faster for a single ray.
const FEW_FOR_ONE: usize = 4;
/// Up to this many shapes a linear scan is faster for a packet outside of all grids.
const FEW_FOR_PACKET: usize = 16;

/// The point or the direction that many rays share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RayBundle {
    /// All of them pass through one point.
    Through(DVec3),
    /// All of them are parallel to one direction of length 1.
    Parallel(DVec3),
}

/// The shapes of a scene, prepared for many rays.
#[derive(Debug)]
pub(crate) struct Accelerator<'a> {
    pub shapes: Shapes<'a>,
    /// The shapes without finite bounds: every ray tests them.
    unbounded: Vec<ShapeId>,
    /// The bounded shapes, if they are few enough for packets to scan.
    few: Option<Vec<ShapeId>>,
    grids: Vec<PerspectiveGrid>,
    /// For rays outside of all grids; built for the first of them.
    trees: OnceLock<Trees>,
}

impl<'a> Accelerator<'a> {
    /// The accelerator of these shapes, for rays most of which belong to these bundles.
    pub fn new(shapes: Shapes<'a>, bundles: impl IntoIterator<Item = RayBundle>) -> Self {
        let (bounded, unbounded): (Vec<_>, Vec<_>) =
            shapes.bounds().partition(|(bounds, _)| bounds.are_finite());
        let are_few = bounded.len() <= FEW_FOR_PACKET;
        let bundles = bundles.into_iter();
        Self {
            few: are_few.then(|| bounded.iter().map(|(_, shape)| *shape).collect()),
            unbounded: unbounded.into_iter().map(|(_, shape)| shape).collect(),
            grids: bundles
                .filter_map(|bundle| PerspectiveGrid::new(bundle, &bounded))
                .collect(),
            trees: OnceLock::new(),
            shapes,
        }
    }

    /// Adds to a plan the tests that are skipped.
    pub fn plan(&self, plan: Plan) -> Plan {
        let plan = if self.grids.is_empty() {
            plan
        } else {
            plan.without(
                "tests of objects beside rays from the eye and to a light",
                "the cells of a perspective grid list the objects that they can hit",
            )
        };
        if self.shapes.len() - self.unbounded.len() <= FEW {
            plan.without(
                "a bounding volume hierarchy",
                "so few objects are tested in turn",
            )
        } else {
            plan.without(
                "tests of objects far from any other ray",
                "a bounding volume hierarchy finds the objects near it",
            )
        }
    }

    /// Whether an object narrower than this share of the side could lie between four
    /// rays, the corners of a square.
    pub fn may_miss_features(&self, corners: &[Ray; 4], feature_size: f64) -> bool {
        // Planes are wide. The width of other shapes without bounds is unknown.
        let is_wide = |shape: &ShapeId| matches!(shape, ShapeId::Plane(_));
        if !self.unbounded.iter().all(is_wide) {
            return true;
        }
        if self.unbounded.len() == self.shapes.len() {
            return false;
        }
        let mut grids = self.grids.iter();
        grids
            .find_map(|grid| grid.may_miss_features(corners, feature_size))
            .unwrap_or(true)
    }

    #[inline]
    fn trees(&self) -> &Trees {
        self.trees.get_or_init(|| Trees::new(&self.shapes))
    }
}
