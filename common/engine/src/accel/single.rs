//! The nearest hit, and any hit, of a single ray.

use super::shapes::{ShapeId, SingleRay};
use super::{Accelerator, FEW_FOR_ONE};
use crate::{Hit, Interval, Ray};

impl Accelerator<'_> {
    /// The nearest hit within the interval and the surface hit; of several at the same
    /// place, the first of the list.
    #[inline]
    pub fn hit(&self, ray: &Ray, within: Interval) -> Option<(Hit, u32)> {
        let tests = SingleRay::new(ray, &self.shapes);
        let mut nearest = Nearest::new(&tests, within);
        if self.shapes.len() <= FEW_FOR_ONE {
            for shape in &self.shapes.in_order {
                nearest.test(*shape);
            }
            return nearest.hit();
        }
        for shape in &self.unbounded {
            nearest.test(*shape);
        }
        let of_grid = self.grids.iter().find_map(|grid| grid.outwards(ray));
        if let Some((candidates, near)) = of_grid {
            for candidate in candidates {
                if f64::from(candidate.near) > near(nearest.within.max) {
                    break;
                }
                nearest.test(candidate.shape);
            }
        } else {
            self.trees().hit(&mut nearest);
        }
        nearest.hit()
    }

    /// Whether anything is hit within the interval.
    #[inline]
    pub fn is_hit(&self, ray: &Ray, within: Interval) -> bool {
        let tests = SingleRay::new(ray, &self.shapes);
        let is_hit = |shape: &ShapeId| tests.hit(*shape, within).is_some();
        if self.shapes.len() <= FEW_FOR_ONE {
            return self.shapes.in_order.iter().any(is_hit);
        }
        if self.unbounded.iter().any(is_hit) {
            return true;
        }
        for grid in &self.grids {
            if let Some(mut shapes) = grid.inwards(ray, within) {
                return shapes.any(|shape| is_hit(&shape));
            }
        }
        self.trees().is_hit(&tests, within)
    }
}

/// The nearest hit so far.
pub(super) struct Nearest<'r, 'a> {
    pub tests: &'r SingleRay<'r, 'a>,
    pub within: Interval,
    found: Option<(Hit, ShapeId)>,
}

impl<'r, 'a> Nearest<'r, 'a> {
    pub const fn new(tests: &'r SingleRay<'r, 'a>, within: Interval) -> Self {
        Self {
            tests,
            within,
            found: None,
        }
    }

    #[inline]
    pub fn test(&mut self, shape: ShapeId) {
        let Some(hit) = self.tests.hit(shape, self.within) else {
            return;
        };
        // At the same place the first of the list counts, in any order of tests.
        let order = |shape| self.tests.shapes.listed(shape).order;
        if let Some((found, other)) = self.found
            && found.t == hit.t
            && order(other) < order(shape)
        {
            return;
        }
        self.within.max = hit.t.next_up();
        self.found = Some((hit, shape));
    }

    fn hit(self) -> Option<(Hit, u32)> {
        let (hit, shape) = self.found?;
        Some((hit, self.tests.shapes.listed(shape).surface))
    }
}
