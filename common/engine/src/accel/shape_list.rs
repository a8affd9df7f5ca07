//! `ShapeList`: the shapes of one kind, and the tests of a leaf of them.

use common::steps::{self, StepKind};
use fearless_simd::prelude::*;

use super::ids::Leaf;
use super::query::Query;
use super::{Occluder, Shapes};
use crate::lanes::{Lanes, Simd, bits, bits_of, splat};
use crate::shape::{List, Primitive, Rays};

/// What a shape is besides its numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Attributes {
    /// Its position in the list of the scene, which breaks ties.
    pub order: u32,
    /// The index of its surface.
    pub surface: u32,
    /// The number of transforms by the identity around it, which are applied to its hits alone.
    pub identities: u32,
}

/// Shapes of one kind and their attributes.
#[derive(Debug, Default)]
pub(crate) struct ShapeList<L> {
    pub shapes: L,
    pub attributes: Vec<Attributes>,
}

impl<L: List> ShapeList<L> {
    /// The list to which a shape with these attributes is to be pushed.
    pub(super) fn with(&mut self, attributes: Attributes) -> &mut L {
        self.attributes.push(attributes);
        &mut self.shapes
    }

    /// Puts the shape that is now at `order[i]` at index `i`. Goes round each cycle of the
    /// permutation once.
    pub(super) fn reorder(&mut self, mut order: Vec<u32>) {
        for start in 0..order.len() {
            let mut to = start;
            loop {
                let from = std::mem::replace(&mut order[to], to as u32) as usize;
                if from == start {
                    break;
                }
                self.shapes.swap(to, from);
                self.attributes.swap(to, from);
                to = from;
            }
        }
    }

    /// The shapes of a leaf side by side; the last one repeats in a leaf of fewer than four.
    #[inline(always)]
    fn four<S: Simd>(&self, simd: S, leaf: Leaf) -> <L::Shape<'_> as Primitive>::Four<S> {
        let first = leaf.first as usize;
        let last = first + usize::from(leaf.count) - 1;
        let [b, c, d] = [1, 2, 3].map(|lane| (first + lane).min(last));
        self.shapes.four(simd, [first, b, c, d])
    }

    /// The `t` at which one ray meets the shapes of a leaf, side by side, and a bit for each shape that it
    /// meets at most at `t_max`.
    #[inline(never)]
    pub(super) fn test_ray<S: Simd>(
        &self,
        leaf: Leaf,
        ray: &Rays<S>,
        t_max: f64,
    ) -> (Lanes<S>, u32) {
        let simd = ray.packet.simd();
        simd.vectorize(
            #[inline(always)]
            || {
                steps::count(StepKind::Test, leaf.count.into());
                let active = (1 << leaf.count) - 1;
                let t_max = splat(simd, t_max);
                let shapes = self.four(simd, leaf);
                let t = <L::Shape<'_> as Primitive>::intersect_before(&shapes, ray, active, t_max);
                (t, bits_of(t.simd_le(t_max)) & active)
            },
        )
    }

    /// Tests the shapes of a leaf, one after the other, against the packets of these queries, a bit
    /// for each.
    #[inline(never)]
    pub(super) fn test_packets<S: Simd>(
        &self,
        shapes: &Shapes,
        leaf: Leaf,
        queries: &mut [Query<S>],
        tested: u32,
        occluder: &mut Occluder,
    ) {
        let simd = queries[0].simd();
        simd.vectorize(
            #[inline(always)]
            || {
                for i in 0..u32::from(leaf.count) {
                    let index = (leaf.first + i) as usize;
                    let (shape, order) =
                        (self.shapes.splat(simd, index), self.attributes[index].order);
                    for query in bits(tested) {
                        let query = &mut queries[query];
                        let active = query.active;
                        if active != 0 {
                            steps::count(StepKind::Test, active.count_ones().into());
                            let (rays, t_max) = (&query.rays, query.t_max);
                            let t = <L::Shape<'_>>::intersect_before(&shape, rays, active, t_max);
                            query.update(t, order, leaf.shape(i), shapes, occluder);
                        }
                    }
                }
            },
        );
    }
}
