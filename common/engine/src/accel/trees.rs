//! `Trees`: a bounding volume hierarchy for each kind of shape that is tested in a way
//! of its own, unless there are few of the kind.

use std::ops::ControlFlow;

use measure::tally::{self, Work};

use super::bvh::{Bvh, WIDTH};
use super::shapes::{ShapeId, Shapes, SingleRay};
use super::single::Nearest;
use crate::Interval;
use crate::lanes::bits;
use crate::shape::{Bounds, SphereBlock, SphereRay, TriangleBlock, TriangleRay};

/// Up to this many shapes of a kind are tested in turn.
pub(super) const FEW: usize = 3;

/// The bounded shapes of a scene.
#[derive(Debug)]
pub(super) struct Trees {
    /// Shapes that every ray tests.
    few: Vec<ShapeId>,
    spheres: Option<Bvh<SphereBlock>>,
    triangles: Option<Bvh<TriangleBlock>>,
    others: Option<Bvh<Vec<ShapeId>>>,
}

impl Trees {
    pub fn new(shapes: &Shapes) -> Self {
        let (mut spheres, mut triangles, mut others) = (Vec::new(), Vec::new(), Vec::new());
        for (bounds, shape) in shapes.bounds().filter(|(bounds, _)| bounds.are_finite()) {
            match shape {
                ShapeId::Sphere(_) => spheres.push((bounds, shape)),
                ShapeId::Triangle(_) => triangles.push((bounds, shape)),
                _ => others.push((bounds, shape)),
            }
        }
        let sphere = |i: u32| shapes.spheres.get(i as usize).map(|(sphere, _)| *sphere);
        let triangle = |i: u32| shapes.triangles.get(i as usize).map(|(t, _)| *t);
        let mut few = Vec::new();
        Self {
            spheres: tree(spheres, &mut few, |leaf| {
                SphereBlock::new(indices(leaf), sphere)
            }),
            triangles: tree(triangles, &mut few, |leaf| {
                TriangleBlock::new(indices(leaf), triangle)
            }),
            others: tree(others, &mut few, <[ShapeId]>::to_vec),
            few,
        }
    }

    /// Looks for a nearer hit.
    #[inline(never)]
    pub fn hit(&self, nearest: &mut Nearest) {
        let (tests, within) = (nearest.tests, nearest.within);
        let _ = self.visit(tests, within, |shape| {
            nearest.test(shape);
            ControlFlow::Continue(nearest.within.max)
        });
    }

    /// Looks for any hit.
    #[inline(never)]
    pub fn is_hit(&self, tests: &SingleRay, within: Interval) -> bool {
        let test = |shape| match tests.hit(shape, within) {
            Some(_) => ControlFlow::Break(()),
            None => ControlFlow::Continue(within.max),
        };
        self.visit(tests, within, test).is_break()
    }

    /// Visits the shapes that the ray may hit within the interval, until `visit`
    /// breaks off; it returns the largest `t` of interest.
    #[inline]
    fn visit(
        &self,
        tests: &SingleRay,
        mut within: Interval,
        mut visit: impl FnMut(ShapeId) -> ControlFlow<(), f64>,
    ) -> ControlFlow<()> {
        let ray = tests.ray;
        for shape in &self.few {
            within.max = visit(*shape)?;
        }
        if let Some(tree) = &self.spheres {
            let sphere_ray = SphereRay::new(ray);
            within.max = tree.search(ray, within, |block, mut max| {
                let candidates = block.candidates(&sphere_ray);
                count_rejected(&block.indices, candidates);
                for lane in bits(candidates) {
                    max = visit(ShapeId::Sphere(block.indices[lane]))?;
                }
                ControlFlow::Continue(max)
            })?;
        }
        if let Some(tree) = &self.triangles {
            let triangle_ray = TriangleRay::new(tests.sheared());
            within.max = tree.search(ray, within, |block, mut max| {
                let candidates = block.candidates(&triangle_ray);
                count_rejected(&block.indices, candidates);
                for lane in bits(candidates) {
                    max = visit(ShapeId::Triangle(block.indices[lane]))?;
                }
                ControlFlow::Continue(max)
            })?;
        }
        if let Some(tree) = &self.others {
            tree.search(ray, within, |leaf, mut max| {
                for shape in leaf {
                    max = visit(*shape)?;
                }
                ControlFlow::Continue(max)
            })?;
        }
        ControlFlow::Continue(())
    }
}

/// The indices of the spheres, or of the triangles, of a leaf.
fn indices(leaf: &[ShapeId]) -> [u32; WIDTH] {
    std::array::from_fn(|lane| match leaf.get(lane) {
        Some(ShapeId::Sphere(index) | ShapeId::Triangle(index)) => *index,
        _ => u32::MAX,
    })
}

/// A tree of these shapes, or none if they are few.
fn tree<L>(
    shapes: Vec<(Bounds, ShapeId)>,
    few: &mut Vec<ShapeId>,
    leaf: impl FnMut(&[ShapeId]) -> L,
) -> Option<Bvh<L>> {
    if shapes.len() <= FEW {
        few.extend(shapes.iter().map(|(_, shape)| *shape));
        return None;
    }
    Some(Bvh::new(shapes, leaf))
}

/// Counts the tests of a block that end here; its candidates are tested once more, for
/// the whole hit.
#[inline]
fn count_rejected(block: &[u32; WIDTH], candidates: u32) {
    if tally::is_on() {
        let shapes = block.iter().filter(|index| **index != u32::MAX);
        let rejected = shapes.count() as u32 - candidates.count_ones();
        tally::count_all(Work::IntersectionTest, rejected.into());
    }
}
