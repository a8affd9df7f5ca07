//! Assignment 4: where rays meet planes, boxes, triangles and spheres.
//!
//! A [`Geometry`] says where a [`Ray`](a03_rays_cameras::Ray) meets it first
//! within an [`Interval`], and knows nothing of colour. The [`World`] pairs each
//! with a surface and finds the nearest.

mod axis_aligned_box;
pub mod fast;
mod geometry;
mod hit;
mod interval;
#[doc(hidden)]
pub mod lab;
mod plane;
mod scenes;
mod sphere;
mod stage;
mod triangle;
mod world;

pub use axis_aligned_box::AxisAlignedBox;
pub use geometry::Geometry;
pub use hit::Hit;
pub use interval::Interval;
#[doc(hidden)]
pub use lab::{counted, explain, protocol};
pub use plane::Plane;
pub use sphere::Sphere;
pub use stage::stage;
pub use triangle::Triangle;
pub use world::World;

/// The code in this stage's chapter is tested with it.
#[cfg(doctest)]
#[doc = include_str!("../../book/src/a04-intersections.md")]
mod book {}
