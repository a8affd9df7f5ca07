//! Assignment 4: intersections of rays with planes, boxes, triangles and spheres.
//!
//! A [`Geometry`] computes its nearest hit by a [`Ray`](a03_rays_cameras::Ray)
//! within an [`Interval`], and has no colour. The [`World`] pairs each geometry
//! with a surface and finds the nearest hit.

mod adapter;
mod axis_aligned_box;
mod geometry;
mod hit;
mod interval;
mod plane;
mod scaled_ray;
#[doc(hidden)]
pub mod scenes;
mod sphere;
mod triangle;
mod world;

#[doc(hidden)]
pub use crate::adapter::instruments;
pub use crate::adapter::registry;
pub use crate::adapter::stage;
pub use axis_aligned_box::AxisAlignedBox;
pub use geometry::Geometry;
pub use hit::Hit;
pub use interval::Interval;
pub use plane::Plane;
pub use scaled_ray::{SQUARED_LENGTHS, hit_of_scaled_ray};
pub use sphere::Sphere;
pub use triangle::Triangle;
pub use world::World;
