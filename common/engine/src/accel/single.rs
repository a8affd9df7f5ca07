//! The nearest hit, and any hit, of a single ray.

use std::ops::ControlFlow;

use super::Accelerator;
use super::bvh::{Bvh, Leaf};
use super::shapes::{Kind, ShapeId, with_list};
use crate::shape::{Primitive, Rays};
use crate::{Hit, Interval, Ray};

impl Accelerator<'_> {
    /// The nearest hit within the interval and the surface hit; of several at the same
    /// place, the first of the list.
    pub fn hit(&self, ray: &Ray, within: Interval) -> Option<(Hit, u32)> {
        let rays = Rays::one(ray, within.min);
        let mut nearest = Nearest::before(within.max);
        for leaf in self.scanned() {
            self.nearest_in(*leaf, &rays, &mut nearest);
        }
        if self.few.is_empty() {
            self.search_nearest(ray, &rays, within.min, &mut nearest);
        }
        let shape = nearest.shape?;
        let hit = with_list!(self.shapes, shape.kind, |list| {
            list.get(shape.index).hit(ray, within)
        })?;
        Some((hit, self.shapes.place(shape).surface))
    }

    /// Whether anything is hit within the interval.
    pub fn is_hit(&self, ray: &Ray, within: Interval) -> bool {
        let rays = Rays::one(ray, within.min);
        let mut scanned = self.scanned().iter();
        scanned.any(|leaf| self.any_in(*leaf, &rays, within.max).is_some())
            || self.few.is_empty() && self.search_any(ray, &rays, within).is_some()
    }

    /// The shapes that a ray alone is tested against without a search.
    fn scanned(&self) -> &[Leaf] {
        if self.few.is_empty() {
            &self.unbounded
        } else {
            &self.few
        }
    }

    /// Looks for a nearer hit in the tree.
    #[inline(never)]
    pub(super) fn search_nearest(&self, ray: &Ray, rays: &Rays, min: f64, nearest: &mut Nearest) {
        let Some(tree) = &self.tree else {
            return;
        };
        let beyond = tree.units.beyond(nearest.t);
        let _ = tree.search_one(ray, min, beyond, |leaf| {
            self.nearest_in(leaf, rays, nearest);
            ControlFlow::Continue(tree.units.beyond(nearest.t))
        });
    }

    /// Looks for any hit in the tree.
    #[inline(never)]
    pub(super) fn search_any(&self, ray: &Ray, rays: &Rays, within: Interval) -> Option<ShapeId> {
        let tree = self.tree.as_ref()?;
        let beyond = tree.units.beyond(within.max);
        let mut found = None;
        let _ = tree.search_one(ray, within.min, beyond, |leaf| {
            found = self.any_in(leaf, rays, within.max);
            match found {
                Some(_) => ControlFlow::Break(()),
                None => ControlFlow::Continue(beyond),
            }
        });
        found
    }

    #[inline]
    fn nearest_in(&self, leaf: Leaf, rays: &Rays, nearest: &mut Nearest) {
        with_list!(self.shapes, leaf.kind, |list| list
            .nearest(leaf, rays, nearest));
    }

    #[inline]
    fn any_in(&self, leaf: Leaf, rays: &Rays, max: f64) -> Option<ShapeId> {
        let hit = with_list!(self.shapes, leaf.kind, |list| list.any(leaf, rays, max));
        hit.map(|i| leaf.shape(i))
    }
}

impl Bvh {
    /// Like `search`, for one ray; visits all leaves if it does not fit into the units of
    /// the tree.
    #[inline]
    fn search_one(
        &self,
        ray: &Ray,
        min: f64,
        beyond: f32,
        mut visit: impl FnMut(Leaf) -> ControlFlow<(), f32>,
    ) -> ControlFlow<()> {
        match self.units.ray(ray, min) {
            Some(slabs) => self.search(&slabs, beyond, |leaf, _, _| visit(leaf)),
            None => self.search_all(visit),
        }
    }
}

/// The nearest hit so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nearest {
    pub t: f64,
    /// The position in the list of the shape hit there.
    pub order: u32,
    pub shape: Option<ShapeId>,
}

impl Nearest {
    /// No hit; those before `max` count.
    pub const fn before(max: f64) -> Self {
        Self {
            t: max,
            // No shape comes before the first of the list.
            order: 0,
            shape: None,
        }
    }
}
