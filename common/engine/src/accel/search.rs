//! `Search`: a search of four rays, and how many of them are carried out together: rays through
//! neighbouring pixels, or from neighbouring points to a lamp, meet much the same nodes.
//!
//! All of them go through the tree as one bundle while they are close to each other; otherwise
//! half of them, and so on, and at last each ray alone. (Wald, Slusallek, Benthin and Wagner,
//! Interactive Rendering with Coherent Ray Tracing, 2001.)

use std::ops::ControlFlow;
use std::slice;

use super::Accelerator;
use super::bvh::Leaf;
use super::shapes::{Kind, ShapeId, with_list};
use crate::lanes::{Lanes, mask, select};
use crate::shape::Rays;

/// Four rays go through the tree together while they are no farther apart than this many
/// leaves are wide.
const FOUR: f32 = 2.0;

/// More than four rays go together while they are no farther apart than this: each is tested
/// against all shapes near any of them.
const MORE: f32 = 0.5;

/// Few shapes are sooner tested than searched for in up to this many searches.
const ALONE: usize = 4;

/// A search for hits of four rays.
pub(crate) trait Search {
    /// A result that serves the next searches, too.
    type Shared;

    /// The rays.
    fn rays(&self) -> &Rays;

    /// A bit for each ray whose search goes on.
    fn open(&self) -> u32;

    /// The greatest `t` at which a hit of an open ray counts; negative if none is open.
    fn beyond(&self) -> f64;

    /// Takes the `t` at which rays hit a shape that has this position in the list; NaN without
    /// a hit.
    fn take(&mut self, t: Lanes, order: u32, shape: ShapeId, shared: &mut Self::Shared);

    /// Tests a shape that is likely to end the search.
    fn guess(&mut self, _: &Accelerator, _: &mut Self::Shared) {}

    /// Searches the tree ray by ray.
    fn search_one_by_one(&mut self, accelerator: &Accelerator, shared: &mut Self::Shared);
}

impl Accelerator<'_> {
    /// Carries out these searches, many at once while their rays are close to each other.
    pub fn search<S: Search>(&self, searches: &mut [S], shared: &mut S::Shared) {
        for search in &mut *searches {
            search.guess(self, shared);
        }
        if searches.iter().all(|search| search.open() == 0) {
            return;
        }
        if searches.len() <= ALONE && !self.few.is_empty() {
            return self.test(&self.few, searches, shared);
        }
        let Some(tree) = &self.tree else {
            return self.test(&self.unbounded, searches, shared);
        };
        let width = if searches.len() == 1 { FOUR } else { MORE };
        let rays = searches.iter();
        let rays = rays.map(|search| (&search.rays().packet, search.open()));
        if let Some(bundle) = tree.units.bundle(rays, width * tree.leaf_width) {
            self.test(&self.unbounded, searches, shared);
            let first = tree.units.beyond(beyond(searches));
            let _ = tree.search(&bundle, first, |leaf| {
                self.test(&[leaf], searches, shared);
                let beyond = beyond(searches);
                if beyond < 0.0 {
                    return ControlFlow::Break(());
                }
                ControlFlow::Continue(tree.units.beyond(beyond))
            });
        } else if let [search] = searches {
            self.test(&self.unbounded, slice::from_mut(search), shared);
            search.search_one_by_one(self, shared);
        } else {
            let (some, others) = searches.split_at_mut(searches.len() / 2);
            self.search(some, shared);
            self.search(others, shared);
        }
    }

    /// Tests shapes in all of these searches.
    pub(super) fn test<S: Search>(
        &self,
        leaves: &[Leaf],
        searches: &mut [S],
        shared: &mut S::Shared,
    ) {
        for leaf in leaves {
            with_list!(self.shapes, leaf.kind, |list| list
                .test(*leaf, searches, shared));
        }
    }
}

/// The greatest of all.
#[inline]
fn beyond(searches: &[impl Search]) -> f64 {
    let all = searches.iter().map(Search::beyond);
    all.fold(f64::NEG_INFINITY, f64::max)
}

/// The largest of the active lanes; negative if none is active.
#[inline]
pub(super) fn largest(lanes: Lanes, active: u32) -> f64 {
    let [a, b, c, d] = select(mask(active), lanes, Lanes::splat(f64::NEG_INFINITY)).to_array();
    a.max(b).max(c.max(d))
}
