//! `Transformed`: a shape under a chain of transforms.
//!
//! The transforms are applied one by one, as the nodes of a scene graph do: their
//! product would round otherwise. Only the bounds come from the product. `flatten` takes
//! it for rays, too, where a picture may have an error.

use common::tally::{self, Work};

use super::transform::norm;
use super::transformed_bounds::transformed_bounds;
use super::{Bounds, Primitive, Rays, Shape, Transform, one_by_one};
use crate::lanes::{Lanes, PacketHit};
use crate::{Hit, Interval, Ray};

/// A shape under transforms.
#[derive(Debug)]
pub struct Transformed<'a> {
    /// From the outermost transform to the innermost.
    steps: Vec<Transform>,
    shape: Box<Shape<'a>>,
    /// Whether a hit is never lost because rounding leaves nothing of its normal.
    keeps_normals: bool,
}

impl<'a> Transformed<'a> {
    pub(super) fn new(transform: &Transform, shape: Box<Shape<'a>>) -> Self {
        Self {
            steps: vec![*transform],
            shape,
            keeps_normals: transform.keeps_normals(),
        }
    }

    pub(super) fn under(mut self, transform: &Transform) -> Self {
        self.keeps_normals &= transform.keeps_normals();
        self.steps.insert(0, *transform);
        self
    }

    /// The transforms, from the outermost to the innermost.
    pub(crate) fn steps(&self) -> &[Transform] {
        &self.steps
    }

    /// Replaces all transforms by one.
    pub(crate) fn flatten(&mut self, product: Transform) {
        self.keeps_normals = product.keeps_normals();
        self.steps = vec![product];
    }

    /// Counts the work of the wanted lanes.
    #[inline]
    fn count(&self, wanted: u32) {
        let tests = u64::from(wanted.count_ones()) * self.steps.len() as u64;
        tally::count_all(Work::MovedRay, tests);
        tally::count_all(Work::IntersectionTest, tests);
    }

    /// Rays in the space of the shape.
    #[inline]
    fn rays_inside(&self, rays: &Rays) -> Rays {
        let steps = self.steps.iter();
        rays.moved(steps.fold(rays.packet, |rays, step| step.rays(&rays)))
    }
}

impl Primitive for &Transformed<'_> {
    /// A leaf holds one of them only.
    type Four = Self;

    fn bounds(self) -> Bounds {
        transformed_bounds(&self.steps, |along| self.shape.reach(along))
    }

    /// No transform makes a length longer than by its norm.
    fn depth_error(self) -> f64 {
        let norms = self.steps.iter().map(|step| norm(step.matrix));
        norms.product::<f64>() * self.shape.depth_error()
    }

    fn hit(self, ray: &Ray, within: Interval) -> Option<Hit> {
        let ray = self.steps.iter().fold(*ray, |ray, step| step.ray(&ray));
        let hit = self.shape.hit(&ray, within)?;
        self.steps.iter().rev().try_fold(hit, |hit, step| {
            Some(Hit {
                t: hit.t,
                normal: step.normal(hit.normal)?,
                face: step.normal(hit.face)?,
            })
        })
    }

    #[inline]
    fn four([shape, ..]: [Self; 4]) -> Self {
        shape
    }

    #[inline]
    fn meet(shape: &Self, rays: &Rays, wanted: u32) -> Lanes {
        shape.count(wanted);
        if !shape.keeps_normals {
            return one_by_one(*shape, rays, wanted).t;
        }
        shape.shape.meet(&shape.rays_inside(rays), wanted)
    }

    fn hits(self, rays: &Rays, t: Lanes, wanted: u32) -> PacketHit {
        let hit = self.shape.hits(&self.rays_inside(rays), t, wanted);
        let mut steps = self.steps.iter().rev();
        let moved = steps.try_fold(hit, |hit, step| {
            let (normal, is_unit) = step.normals(hit.normal);
            let (face, is_unit_face) = step.normals(hit.face);
            let is_unit = (is_unit & is_unit_face).to_bitmask();
            (wanted & !is_unit == 0).then_some(PacketHit { t, normal, face })
        });
        moved.unwrap_or_else(|| one_by_one(self, rays, wanted))
    }
}
