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
mod transformed;
mod transformed_bounds;
mod triangle;

use std::fmt;

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
pub(crate) use transformed::Transformed;
pub use transformed::{Step, Transform};
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
            shape => Transformed::new(transform, shape),
        })
    }

    pub(crate) fn bounds(&self) -> Bounds {
        match self {
            Self::Sphere(shape) => shape.bounds(),
            Self::Plane(shape) => shape.bounds(),
            Self::Box(shape) => shape.bounds(),
            Self::Triangle(shape) => shape.bounds(),
            Self::Disc(shape) => shape.bounds(),
            Self::Transformed(shape) => shape.bounds(),
            Self::Other(shape) => shape.bounds(),
        }
    }

    pub(crate) fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        match self {
            Self::Sphere(shape) => shape.hit(ray, within),
            Self::Plane(shape) => shape.hit(ray, within),
            Self::Box(shape) => shape.hit(ray, within),
            Self::Triangle(shape) => shape.hit(ray, within),
            Self::Disc(shape) => shape.hit(ray, within),
            Self::Transformed(shape) => shape.hit(ray, within),
            Self::Other(shape) => shape.hit(ray, within),
        }
    }
}

impl Primitive for &Other<'_> {
    type Four = [Self; 4];

    fn bounds(self) -> Bounds {
        Bounds::EVERYWHERE
    }

    fn hit(self, ray: &Ray, within: Interval) -> Option<Hit> {
        (self.0)(ray, within)
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
