//! `Transformed`: a shape under a chain of transforms.
//!
//! The transforms are applied one by one, as the nodes of a scene graph do: their
//! product would round otherwise. `flatten` takes the product where a picture may
//! have an error.

use glam::{DMat4, DVec3};
use measure::tally::{self, Work};

use super::transformed_bounds::transformed_bounds;
use super::{Bounds, Primitive, Rays, Shape, one_by_one};
use crate::lanes::{Lanes, PacketHit};
use crate::vector::normalized;
use crate::{Hit, Interval, Ray};

/// A matrix and its inverse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// From the space of the object to the space around it.
    pub matrix: DMat4,
    /// From the space around the object to its own.
    pub inverse: DMat4,
}

/// A shape under transforms.
#[derive(Debug)]
pub struct Transformed<'a> {
    /// From the outermost transform to the innermost.
    pub(crate) steps: Vec<Step>,
    shape: Box<Shape<'a>>,
}

impl<'a> Transformed<'a> {
    pub(super) fn new(transform: &Transform, shape: Shape<'a>) -> Self {
        Self {
            steps: vec![Step::new(transform)],
            shape: Box::new(shape),
        }
    }

    pub(super) fn under(mut self, transform: &Transform) -> Self {
        self.steps.insert(0, Step::new(transform));
        self
    }
}

impl Primitive for &Transformed<'_> {
    type Four = [Self; 4];

    fn bounds(self) -> Bounds {
        let inwards = self.steps.iter().rev();
        inwards.fold(self.shape.bounds(), |bounds, step| {
            transformed_bounds(bounds, &step.transform)
        })
    }

    fn hit(self, ray: &Ray, within: Interval) -> Option<Hit> {
        tally::count_all(Work::MovedRay, self.steps.len() as u64);
        tally::count_all(Work::IntersectionTest, self.steps.len() as u64);
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

    fn four(shapes: [Self; 4]) -> Self::Four {
        shapes
    }

    fn meet(shapes: &Self::Four, rays: &Rays, wanted: u32) -> Lanes {
        one_by_one(*shapes, rays, wanted).t
    }

    fn hits(self, rays: &Rays, _: Lanes, wanted: u32) -> PacketHit {
        one_by_one([self; 4], rays, wanted)
    }
}

/// One transform of a chain.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    pub(crate) transform: Transform,
    /// The inverse, transposed: it moves normals.
    transposed: DMat4,
    scale_translate: Option<ScaleTranslate>,
}

impl Step {
    pub(crate) fn new(transform: &Transform) -> Self {
        Self {
            transform: *transform,
            transposed: transform.inverse.transpose(),
            scale_translate: ScaleTranslate::new(transform.inverse),
        }
    }

    /// Whether rays are moved without a matrix.
    pub(crate) const fn is_scale_translate(&self) -> bool {
        self.scale_translate.is_some()
    }

    /// The ray in the space of the object. Its direction keeps the length that the
    /// inverse gives it, so that `t` means the same in both spaces.
    pub(crate) fn ray(&self, ray: &Ray) -> Ray {
        if let Some(simple) = &self.scale_translate {
            return Ray {
                origin: simple.factors * ray.origin + simple.translation,
                direction: simple.factors * ray.direction,
            };
        }
        let inverse = &self.transform.inverse;
        Ray {
            origin: inverse.transform_point3(ray.origin),
            direction: inverse.transform_vector3(ray.direction),
        }
    }

    /// A normal in the space around the object, of length 1; none if rounding leaves
    /// nothing of it.
    fn normal(&self, n: DVec3) -> Option<DVec3> {
        normalized(match &self.scale_translate {
            Some(simple) => simple.factors * n,
            None => self.transposed.transform_vector3(n),
        })
    }
}

/// The inverse of a transform without rotation: `x' = factor x + translation`, axis by
/// axis.
///
/// The matrix adds 0 times the other coordinates, which rounds nothing: the results
/// are the same to the last bit. (The sign of a 0 may differ, on which no formula
/// depends.)
#[derive(Clone, Copy, Debug)]
struct ScaleTranslate {
    factors: DVec3,
    translation: DVec3,
}

impl ScaleTranslate {
    fn new(inverse: DMat4) -> Option<Self> {
        let columns = inverse.to_cols_array_2d();
        let is_zero = |row: usize, column: usize| row == column || columns[column][row] == 0.0;
        (0..3)
            .all(|row| (0..3).all(|column| is_zero(row, column)))
            .then(|| Self {
                factors: [0, 1, 2].map(|axis| columns[axis][axis]).into(),
                translation: inverse.w_axis.truncate(),
            })
    }
}
