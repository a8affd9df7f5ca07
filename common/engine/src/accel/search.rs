//! `Search`: a search of four rays, and how many of them are carried out together: rays through
//! neighbouring pixels, or from neighbouring points to a lamp, meet much the same nodes.
//!
//! All of them go through the tree as one bundle while they are close to each other; otherwise
//! half of them, and so on, and at last each ray alone. (Wald, Slusallek, Benthin and Wagner,
//! Interactive Rendering with Coherent Ray Tracing, 2001.)

use std::ops::ControlFlow;
use std::slice;

use arrayvec::ArrayVec;
use wide::f32x8;

use super::Accelerator;
use super::bundle::{Bundle, Members, SEARCHES};
use super::bvh::{Bvh, Leaf};
use super::shapes::{Kind, ShapeId, with_list};
use crate::lanes::{Lanes, RayPacket, bits, mask, select};
use crate::shape::Rays;

/// Rays go through the tree together while they are no farther apart than this many leaves are
/// wide.
const APART: f32 = 2.0;

/// After this many leaves the searches of a bundle are told apart. Preparing that takes time, and
/// many bundles meet no more leaves.
const TOLD_APART_AFTER: u32 = 2;

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
    /// Carries out these searches, at most [`SEARCHES`], many at once while their rays are close
    /// to each other.
    pub fn search<S: Search>(&self, searches: &mut [S], shared: &mut S::Shared) {
        for search in &mut *searches {
            search.guess(self, shared);
        }
        self.search_on(searches, shared);
    }

    /// Goes on with the searches that their guesses have not ended.
    fn search_on<S: Search>(&self, searches: &mut [S], shared: &mut S::Shared) {
        if searches.iter().all(|search| search.open() == 0) {
            return;
        }
        if searches.len() <= ALONE && !self.few.is_empty() {
            return self.test_all(&self.few, searches, shared);
        }
        let Some(tree) = &self.tree else {
            return self.test_all(&self.unbounded, searches, shared);
        };
        let bundle =
            rays_of(searches).and_then(|rays| tree.units.bundle(&rays, APART * tree.leaf_width));
        if let Some(bundle) = bundle {
            self.test_all(&self.unbounded, searches, shared);
            self.search_together(tree, &bundle, searches, shared);
        } else if let [search] = searches {
            self.test_all(&self.unbounded, slice::from_mut(search), shared);
            search.search_one_by_one(self, shared);
        } else {
            let (some, others) = searches.split_at_mut(searches.len() / 2);
            self.search_on(some, shared);
            self.search_on(others, shared);
        }
    }

    /// Carries out the searches of a bundle, which go through the tree together.
    fn search_together<S: Search>(
        &self,
        tree: &Bvh,
        bundle: &Bundle,
        searches: &mut [S],
        shared: &mut S::Shared,
    ) {
        let mut beyond = [f32::NEG_INFINITY; SEARCHES];
        for (beyond, search) in beyond.iter_mut().zip(&*searches) {
            *beyond = tree.units.beyond(search.beyond());
        }
        let every = (1 << searches.len()) - 1;
        let (mut leaves, mut members) = (0, None);
        let _ = tree.search(&bundle.all, greatest(&beyond), |leaf, node, child| {
            if leaves == TOLD_APART_AFTER && searches.len() > 1 {
                members = rays_of(searches).map(|rays| tree.units.members(bundle, &rays));
            }
            leaves += 1;
            let meeting = |members: &Members| members.meeting(node, child, &beyond);
            let some = members.as_ref().map_or(every, meeting);
            self.test(leaf, searches, some, shared);
            for i in bits(some) {
                beyond[i] = tree.units.beyond(searches[i].beyond());
            }
            let beyond = greatest(&beyond);
            if beyond < 0.0 {
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(beyond)
        });
    }

    /// Tests shapes in all of these searches.
    pub(super) fn test_all<S: Search>(
        &self,
        leaves: &[Leaf],
        searches: &mut [S],
        shared: &mut S::Shared,
    ) {
        for leaf in leaves {
            self.test(*leaf, searches, (1 << searches.len()) - 1, shared);
        }
    }

    /// Tests shapes in some of these searches, a bit for each.
    #[inline]
    fn test<S: Search>(&self, leaf: Leaf, searches: &mut [S], some: u32, shared: &mut S::Shared) {
        if some != 0 {
            with_list!(self.shapes, leaf.kind, |list| list
                .test(leaf, searches, some, shared));
        }
    }
}

/// The rays of these searches, if any is open. One that is over must not keep the others apart, so
/// it is given the rays of the first open one.
#[inline]
fn rays_of<S: Search>(searches: &[S]) -> Option<ArrayVec<&RayPacket, SEARCHES>> {
    let first = searches.iter().find(|search| search.open() != 0)?;
    let rays = searches.iter().map(|search| match search.open() {
        0 => &first.rays().packet,
        _ => &search.rays().packet,
    });
    Some(rays.collect())
}

/// The greatest of all.
#[inline]
fn greatest(beyond: &[f32; SEARCHES]) -> f32 {
    let (eights, _) = beyond.as_chunks::<8>();
    let all = f32x8::new(eights[0]).fast_max(f32x8::new(eights[1]));
    all.to_array()
        .into_iter()
        .fold(f32::NEG_INFINITY, |a, b| if a > b { a } else { b })
}

/// The largest of the active lanes; negative if none is active.
#[inline]
pub(super) fn largest(lanes: Lanes, active: u32) -> f64 {
    let [a, b, c, d] = select(mask(active), lanes, Lanes::splat(f64::NEG_INFINITY)).to_array();
    a.max(b).max(c.max(d))
}
