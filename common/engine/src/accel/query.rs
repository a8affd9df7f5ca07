//! `Query`: four rays and the hits that they look for.

use fearless_simd::prelude::*;

use super::ids::ShapeId;
use super::shadow::Shadow;
use super::{Occluder, Shapes};
use crate::lanes::{Lanes, RayPacket, bits_of, lanes, splat};
use crate::shape::Rays;

/// A query for hits of four rays: for the nearest ones, or for any that block a light. It finds the
/// same hits in any order of tests.
///
/// Both are one type, so that the traversal and the tests are compiled once.
pub(crate) struct Query<'q, S: Simd> {
    pub(super) rays: Rays<S>,
    /// A bit for each ray that still looks for hits.
    pub(super) active: u32,
    /// The `t` before which hits count: of the nearest hits so far, or of the light.
    pub(super) t_max: Lanes<S>,
    /// The positions in the list of the scene of the shapes that have been hit; below 0 without a hit.
    pub(super) orders: Lanes<S>,
    /// The bits of the ids of the nearest of these shapes.
    pub(super) shapes: Lanes<S>,
    /// The light of a query for hits that block it.
    pub(super) shadow: Option<Shadow<'q, S>>,
}

impl<S: Simd> Query<'_, S> {
    /// A query for the nearest hits of the active of four rays.
    #[inline(always)]
    pub fn nearest(packet: &RayPacket<S>, active: u32) -> Self {
        let simd = packet.simd();
        Self {
            rays: Rays::four(packet, active),
            active,
            t_max: splat(simd, f64::INFINITY),
            orders: splat(simd, -1.0),
            shapes: splat(simd, 0.0),
            shadow: None,
        }
    }

    /// The instructions for its lanes.
    #[inline(always)]
    pub fn simd(&self) -> S {
        self.t_max.simd
    }

    /// The `t` before which hits count. After a query for the nearest hits, their `t`.
    #[inline(always)]
    pub fn t_max(&self) -> Lanes<S> {
        self.t_max
    }

    /// A bit for each ray with a hit: of any shape, or of one that blocks the light.
    #[inline(always)]
    pub fn hit_mask(&self) -> u32 {
        bits_of(self.orders.simd_ge(0.0))
    }

    /// Takes the `t` at which the rays hit a shape with this position in the list of the scene;
    /// NaN without a hit.
    #[inline(always)]
    pub(super) fn update(
        &mut self,
        t: Lanes<S>,
        order: u32,
        shape: ShapeId,
        shapes: &Shapes,
        occluder: &mut Occluder,
    ) {
        if self.shadow.is_some() {
            self.update_shadow(t, order, shape, shapes, occluder);
        } else {
            self.update_nearest(t, order, shape);
        }
    }

    /// Takes a hit of one ray, at most at its `t_max`.
    #[inline(always)]
    pub(super) fn update_ray(
        &mut self,
        lane: usize,
        t: f64,
        order: u32,
        shape: ShapeId,
        shapes: &Shapes,
        occluder: &mut Occluder,
    ) {
        if self.shadow.is_some() {
            let mut of_lane = [f64::NAN; 4];
            of_lane[lane] = t;
            let t = lanes(self.simd(), of_lane);
            self.update_shadow(t, order, shape, shapes, occluder);
        } else {
            self.update_nearest_of_ray(lane, t, order, shape);
        }
    }
}
