//! `Shape`: the shapes whose formulas the engine has, and a function for all others.

mod axis_aligned_box;
mod bounds;
mod disc;
mod mesh;
mod plane;
mod pool;
mod primitive;
mod rays;
mod sheared_ray;
mod sphere;
mod transform;
mod transformed;
mod transformed_bounds;
mod triangle;

use std::fmt;

use glam::DVec3;

use crate::lanes::{Lanes, PacketHit};
use crate::{Hit, Interval, Ray};

pub use axis_aligned_box::AxisAlignedBox;
pub(crate) use bounds::Bounds;
pub use disc::Disc;
pub(crate) use mesh::Mesh;
pub use plane::Plane;
pub(crate) use primitive::{Primitive, one_by_one};
pub(crate) use rays::Rays;
pub(crate) use sheared_ray::{ShearedRay, ShearedRays};
pub use sphere::Sphere;
pub use transform::Transform;
pub(crate) use transformed::Transformed;
pub(crate) use triangle::Corners;
pub use triangle::Triangle;

/// Finds the nearest hit of a ray within an interval, its normals pointing out of the
/// shape.
pub type HitFn<'a> = Box<dyn Fn(&Ray, Interval) -> Option<Hit> + Send + Sync + 'a>;

/// A shape.
#[derive(Debug)]
pub enum Shape<'a> {
    /// All points at one distance from a centre.
    Sphere(Sphere),
    /// Flat and endless.
    Plane(Plane),
    /// Its faces are perpendicular to the axes.
    Box(AxisAlignedBox),
    /// Three corners, each with a shading normal.
    Triangle(Triangle),
    /// The part of a plane around a point.
    Disc(Disc),
    /// A shape under one or more transforms.
    Transformed(Transformed<'a>),
    /// A shape that the engine does not know: each ray is tested by this function.
    Other(Other<'a>),
}

/// The function of a shape that the engine does not know.
pub struct Other<'a>(HitFn<'a>);

impl fmt::Debug for Other<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Other")
    }
}

impl<'a> Shape<'a> {
    /// A shape that the engine does not know.
    pub fn other(hit: impl Fn(&Ray, Interval) -> Option<Hit> + Send + Sync + 'a) -> Self {
        Self::Other(Other(Box::new(hit)))
    }

    /// The same shape under one more transform, which is applied after those that it
    /// has.
    #[must_use]
    pub fn transformed(self, transform: &Transform) -> Self {
        Self::Transformed(match self {
            Self::Transformed(shape) => shape.under(transform),
            shape => Transformed::new(transform, Box::new(shape)),
        })
    }
}

/// Evaluates an expression for the primitive of a shape.
macro_rules! with_primitive {
    ($shape:expr, |$primitive:ident| $body:expr) => {
        match $shape {
            Shape::Sphere($primitive) => $body,
            Shape::Plane($primitive) => $body,
            Shape::Box($primitive) => $body,
            Shape::Triangle($primitive) => {
                let $primitive = *$primitive;
                $body
            }
            Shape::Disc($primitive) => $body,
            Shape::Transformed($primitive) => $body,
            Shape::Other($primitive) => $body,
        }
    };
}

impl Shape<'_> {
    fn reach(&self, along: DVec3) -> f64 {
        with_primitive!(self, |primitive| primitive.reach(along))
    }

    fn depth_error(&self) -> f64 {
        with_primitive!(self, |primitive| primitive.depth_error())
    }

    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        with_primitive!(self, |primitive| primitive.hit(ray, within))
    }

    #[inline]
    fn meet(&self, rays: &Rays, wanted: u32) -> Lanes {
        with_primitive!(self, |primitive| meet(primitive, rays, wanted))
    }

    fn hits(&self, rays: &Rays, t: Lanes, wanted: u32) -> PacketHit {
        with_primitive!(self, |primitive| primitive.hits(rays, t, wanted))
    }
}

/// Where four rays meet one shape.
#[inline]
fn meet<P: Primitive>(shape: P, rays: &Rays, wanted: u32) -> Lanes {
    P::meet(&P::four([shape; 4]), rays, wanted)
}

impl Primitive for &Other<'_> {
    /// A leaf holds one of them only.
    type Four = Self;

    fn hit(self, ray: &Ray, within: Interval) -> Option<Hit> {
        (self.0)(ray, within)
    }

    fn four([shape, ..]: [Self; 4]) -> Self {
        shape
    }

    fn meet(shape: &Self, rays: &Rays, wanted: u32) -> Lanes {
        one_by_one(*shape, rays, wanted).t
    }

    fn hits(self, rays: &Rays, _: Lanes, wanted: u32) -> PacketHit {
        one_by_one(self, rays, wanted)
    }
}
