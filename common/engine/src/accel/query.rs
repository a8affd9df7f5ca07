//! `Query`: four rays and the hits that they look for.

use super::Shapes;
use super::ids::ShapeId;
use crate::lanes::{Lanes, Simd};
use crate::shape::Rays;

/// A query for hits of four rays. It finds the same hits in any order of tests.
pub(crate) trait Query<S: Simd> {
    /// A result that later queries use, too.
    type Shared;

    /// The rays.
    fn rays(&self) -> &Rays<S>;

    /// The instructions for its lanes.
    #[inline(always)]
    fn simd(&self) -> S {
        self.rays().packet.simd()
    }

    /// A bit for each ray that still looks for hits.
    fn active(&self) -> u32;

    /// The `t` before which hits count.
    fn t_max(&self) -> &Lanes<S>;

    /// A shape that is likely to end the query, to be tested first.
    fn guess(_: &Self::Shared) -> Option<ShapeId> {
        None
    }

    /// Takes the `t` at which the rays hit a shape with this position in the list of the scene;
    /// NaN without a hit.
    fn update(
        &mut self,
        t: Lanes<S>,
        order: u32,
        shape: ShapeId,
        shapes: &Shapes,
        shared: &mut Self::Shared,
    );

    /// Takes a hit of one ray, at most at its `t_max`.
    fn update_ray(
        &mut self,
        lane: usize,
        t: f64,
        order: u32,
        shape: ShapeId,
        shapes: &Shapes,
        shared: &mut Self::Shared,
    );
}
