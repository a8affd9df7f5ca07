//! `Transformed`: a shape under a chain of transforms.
//!
//! The transforms are applied one by one, as the nodes of a scene graph do: their
//! product would round otherwise. Only the bounds come from the product.

use common::steps::{self, StepKind};
use glam::DMat4;

use super::transform::spectral_norm;
use super::transformed_bounds::transformed_bounds;
use super::{Bounds, Counts, Primitive, Rays, Shape, Transform};
use crate::lanes::{Lanes, PacketHit, RayPacket, Simd};

/// A shape under transforms.
pub struct Transformed<'a> {
    /// From the outermost transform to the innermost.
    pub(crate) steps: Vec<Transform>,
    pub(crate) shape: Box<Shape<'a>>,
}

impl Transformed<'_> {
    /// Leaves rays as they are at each step that is the identity. Returns whether all are.
    pub(crate) fn omit_identities(&mut self) -> bool {
        for step in &mut self.steps {
            step.moves_rays = step.inverse != DMat4::IDENTITY;
        }
        self.steps.iter().all(|step| !step.moves_rays)
    }

    /// Counts the work of the active lanes.
    #[inline]
    fn count(&self, active: u32) {
        let moving = self.steps.iter().filter(|step| step.moves_rays);
        let tests = u64::from(active.count_ones()) * moving.count() as u64;
        steps::count(StepKind::ObjectRay, tests);
        steps::count(StepKind::Test, tests);
    }

    /// Rays in the space of the shape.
    #[inline(always)]
    fn rays_inside<S: Simd>(&self, rays: &Rays<S>) -> Rays<S> {
        let mut packet = rays.packet;
        for step in &self.steps {
            packet = step.rays(&packet);
        }
        rays.with_packet(packet)
    }

    /// The hits of the shape under these steps, the innermost.
    fn hits_in<S: Simd>(
        &self,
        steps: &[Transform],
        rays: &Rays<S>,
        t: Lanes<S>,
        active: u32,
    ) -> PacketHit<S> {
        t.simd.vectorize(
            #[inline(always)]
            || {
                let Some((step, inner)) = steps.split_first() else {
                    return self.shape.hits(rays, t, active);
                };
                let object_rays = rays.with_packet(step.rays(&rays.packet));
                let hit = self.hits_in(inner, &object_rays, t, active);
                hits_around(step, &hit, &rays.packet)
            },
        )
    }

    /// [`Primitive::any_hit_of_parts`] of the shape under these steps, the innermost.
    fn any_hit_in<S: Simd>(
        &self,
        steps: &[Transform],
        rays: &Rays<S>,
        before: Lanes<S>,
        active: u32,
        counts: Counts<S>,
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

/// Four hits in the space around this many transforms by the identity.
pub(crate) fn hits_around_identities<S: Simd>(
    count: u32,
    hit: PacketHit<S>,
    rays: &RayPacket<S>,
) -> PacketHit<S> {
    rays.simd().vectorize(
        #[inline(always)]
        || (0..count).fold(hit, |hit, _| hits_around(&Transform::IDENTITY, &hit, rays)),
    )
}

/// Four hits in the space around a transformed object.
#[inline(always)]
fn hits_around<S: Simd>(step: &Transform, hit: &PacketHit<S>, rays: &RayPacket<S>) -> PacketHit<S> {
    PacketHit {
        t: hit.t,
        normal: step.normals(hit.normal),
        geometric_normal: step.normals(hit.geometric_normal),
        scale: step.scales(hit, rays),
    }
}

impl Primitive for &Transformed<'_> {
    /// A leaf holds one of them only.
    type Four<S: Simd> = Self;

    fn bounds(self) -> Bounds {
        transformed_bounds(&self.steps, |along| self.shape.support(along))
    }

    /// No transform makes a length longer than by its norm, which is rounded.
    fn depth_error(self) -> f64 {
        let norms = self.steps.iter().map(|step| spectral_norm(step.matrix));
        norms.product::<f64>() * (1.0 + 1e-9) * self.shape.depth_error()
    }

    #[inline(always)]
    fn four<S: Simd>(_: S, [shape, ..]: [Self; 4]) -> Self {
        shape
    }

    #[inline(always)]
    fn intersect<S: Simd>(shape: &Self, rays: &Rays<S>, active: u32) -> Lanes<S> {
        shape.count(active);
        rays.packet.simd().vectorize(
            #[inline(always)]
            || shape.shape.intersect(&shape.rays_inside(rays), active),
        )
    }

    #[inline(always)]
    fn intersect_before<S: Simd>(
        shape: &Self,
        rays: &Rays<S>,
        active: u32,
        t_max: Lanes<S>,
    ) -> Lanes<S> {
        match &*shape.shape {
            Shape::Instance(instance) => {
                shape.count(active);
                instance.nearest_before(&shape.rays_inside(rays), active, t_max)
            }
            _ => Self::intersect(shape, rays, active),
        }
    }

    fn hits<S: Simd>(self, rays: &Rays<S>, t: Lanes<S>, active: u32) -> PacketHit<S> {
        self.hits_in(&self.steps, rays, t, active)
    }

    fn any_hit_of_parts<S: Simd>(
        self,
        rays: &Rays<S>,
        before: Lanes<S>,
        active: u32,
        counts: Counts<S>,
    ) -> u32 {
        self.any_hit_in(&self.steps, rays, before, active, counts)
    }
}
