//! `Instance`: shapes that stand in several places of a scene, with one tree in memory.
//!
//! The rays of each place are moved into the space of the shapes by the transforms around the
//! instance, and traverse the tree there. (Rubin and Whitted, A 3-Dimensional Representation for
//! Fast Rendering of Complex Scenes, 1980.)

use std::sync::Arc;

use fearless_simd::prelude::*;
use glam::DVec3;

use super::{Bounds, Counts, Primitive, Rays, Shape};
use crate::accel::{Accelerator, Query, Shapes};
use crate::lanes::{Lanes, PacketHit, mask, no_hit, splat};

/// Shapes that stand in several places. A clone shares them.
#[derive(Clone)]
pub struct Instance<'a>(Arc<Prototype<'a>>);

/// The shapes of instances, prepared for many rays.
struct Prototype<'a> {
    accelerator: Accelerator<'a>,
    /// The bounds of all shapes.
    bounds: Bounds,
    /// The largest depth error of a shape.
    depth_error: f64,
}

impl<'a> Instance<'a> {
    /// Of several of these shapes hit at the same `t`, the first counts.
    #[must_use]
    pub fn new(shapes: Vec<Shape<'a>>) -> Self {
        let mut all = Shapes::default();
        for shape in shapes {
            all.push(shape, 0);
        }
        all.omit_identities();
        let bounds = all.bounds().map(|(_, bounds)| bounds);
        Self(Arc::new(Prototype {
            bounds: bounds.fold(Bounds::EMPTY, Bounds::union),
            depth_error: all.largest_depth_error(),
            accelerator: Accelerator::new(all),
        }))
    }

    /// The nearest hits of four rays, if they are not behind `t_max`.
    fn query<S: Simd>(&self, rays: &Rays<S>, active: u32, t_max: Lanes<S>) -> Query<'static, S> {
        t_max.simd.vectorize(
            #[inline(always)]
            || {
                let mut query = Query::nearest(&rays.packet, active).not_behind(t_max);
                self.0.accelerator.traverse_rays(&mut query);
                query
            },
        )
    }

    /// The `t` of the nearest hits of four rays; NaN without a hit, or if it is behind `t_max`.
    pub(super) fn nearest_before<S: Simd>(
        &self,
        rays: &Rays<S>,
        active: u32,
        t_max: Lanes<S>,
    ) -> Lanes<S> {
        let query = self.query(rays, active, t_max);
        mask(t_max.simd, query.hit_mask()).select(query.t_max(), no_hit(t_max.simd))
    }
}

impl Primitive for &Instance<'_> {
    /// A leaf holds one of them only.
    type Four<S: Simd> = Self;

    /// That of the box around all shapes.
    fn support(self, along: DVec3) -> f64 {
        let Bounds { min, max } = self.0.bounds;
        if !self.0.bounds.are_finite() {
            return f64::INFINITY;
        }
        let farthest = |axis: usize| (min[axis] * along[axis]).max(max[axis] * along[axis]);
        farthest(0) + farthest(1) + farthest(2)
    }

    fn depth_error(self) -> f64 {
        self.0.depth_error
    }

    fn four<S: Simd>(_: S, [shape, ..]: [Self; 4]) -> Self {
        shape
    }

    fn intersect<S: Simd>(shape: &Self, rays: &Rays<S>, active: u32) -> Lanes<S> {
        shape.nearest_before(rays, active, splat(rays.packet.simd(), f64::INFINITY))
    }

    /// Looks for the nearest hits again, which are those that `intersect` has found.
    #[inline(always)]
    fn hits<S: Simd>(self, rays: &Rays<S>, t: Lanes<S>, active: u32) -> PacketHit<S> {
        let query = self.query(rays, active, t);
        self.0.accelerator.shapes.hits_outwards(&query).hit
    }

    fn any_hit_of_parts<S: Simd>(
        self,
        rays: &Rays<S>,
        before: Lanes<S>,
        active: u32,
        counts: Counts<S>,
    ) -> u32 {
        let mut query = Query::shadow_inside(&rays.packet, before, active, counts);
        self.0.accelerator.traverse_rays(&mut query);
        query.hit_mask()
    }
}
