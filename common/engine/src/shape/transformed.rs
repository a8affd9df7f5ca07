//! `Transformed`: a shape under a chain of transforms.
//!
//! The transforms are applied one by one, as the nodes of a scene graph do: their
//! product would round otherwise. Only the bounds come from the product.

use common::steps::{self, StepKind};

use super::transform::spectral_norm;
use super::transformed_bounds::transformed_bounds;
use super::{Bounds, Counts, Primitive, Rays, Shape, Transform};
use crate::lanes::{Lanes, PacketHit, RayPacket};

/// A shape under transforms.
pub struct Transformed<'a> {
    /// From the outermost transform to the innermost.
    pub(crate) steps: Vec<Transform>,
    pub(crate) shape: Box<Shape<'a>>,
}

impl Transformed<'_> {
    /// Counts the work of the active lanes.
    #[inline]
    fn count(&self, active: u32) {
        let tests = u64::from(active.count_ones()) * self.steps.len() as u64;
        steps::count(StepKind::ObjectRay, tests);
        steps::count(StepKind::Test, tests);
    }

    /// Rays in the space of the shape.
    #[inline]
    fn rays_inside(&self, rays: &Rays) -> Rays {
        let steps = self.steps.iter();
        rays.with_packet(steps.fold(rays.packet, |rays, step| step.rays(&rays)))
    }

    /// The hits of the shape under these steps, the innermost.
    fn hits_in(&self, steps: &[Transform], rays: &Rays, t: Lanes, active: u32) -> PacketHit {
        let Some((step, inner)) = steps.split_first() else {
            return self.shape.hits(rays, t, active);
        };
        let object_rays = rays.with_packet(step.rays(&rays.packet));
        let hit = self.hits_in(inner, &object_rays, t, active);
        hits_around(step, &hit, &rays.packet)
    }

    /// [`Primitive::any_hit_of_parts`] of the shape under these steps, the innermost.
    fn any_hit_in(
        &self,
        steps: &[Transform],
        rays: &Rays,
        before: Lanes,
        active: u32,
        counts: Counts,
    ) -> u32 {
        let Some((step, inner)) = steps.split_first() else {
            return self.shape.any_hit_of_parts(rays, before, active, counts);
        };
        let object_rays = rays.with_packet(step.rays(&rays.packet));
        self.any_hit_in(inner, &object_rays, before, active, &|hit| {
            counts(&hits_around(step, hit, &rays.packet))
        })
    }
}

/// Four hits in the space around a transformed object.
fn hits_around(step: &Transform, hit: &PacketHit, rays: &RayPacket) -> PacketHit {
    PacketHit {
        t: hit.t,
        normal: step.normals(hit.normal),
        geometric_normal: step.normals(hit.geometric_normal),
        scale: step.scales(hit, rays),
    }
}

impl Primitive for &Transformed<'_> {
    /// A leaf holds one of them only.
    type Four = Self;

    fn bounds(self) -> Bounds {
        transformed_bounds(&self.steps, |along| self.shape.support(along))
    }

    /// No transform makes a length longer than by its norm, which is rounded.
    fn depth_error(self) -> f64 {
        let norms = self.steps.iter().map(|step| spectral_norm(step.matrix));
        norms.product::<f64>() * (1.0 + 1e-9) * self.shape.depth_error()
    }

    #[inline]
    fn four([shape, ..]: [Self; 4]) -> Self {
        shape
    }

    #[inline]
    fn intersect(shape: &Self, rays: &Rays, active: u32) -> Lanes {
        shape.count(active);
        shape.shape.intersect(&shape.rays_inside(rays), active)
    }

    #[inline]
    fn intersect_before(shape: &Self, rays: &Rays, active: u32, t_max: Lanes) -> Lanes {
        match &*shape.shape {
            Shape::Instance(instance) => {
                shape.count(active);
                instance.nearest_before(&shape.rays_inside(rays), active, t_max)
            }
            _ => Self::intersect(shape, rays, active),
        }
    }

    fn hits(self, rays: &Rays, t: Lanes, active: u32) -> PacketHit {
        self.hits_in(&self.steps, rays, t, active)
    }

    fn any_hit_of_parts(self, rays: &Rays, before: Lanes, active: u32, counts: Counts) -> u32 {
        self.any_hit_in(&self.steps, rays, before, active, counts)
    }
}
