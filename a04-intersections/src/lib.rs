//! Assignment 4: where rays meet planes, boxes, triangles and spheres.
//!
//! A [`Geometry`] says where a [`Ray`](a03_rays_cameras::Ray) meets it first
//! within an [`Interval`], and knows nothing of colour. The [`World`] pairs each
//! with a surface and finds the nearest.

mod axis_aligned_box;
mod bounds;
mod geometry;
mod hit;
mod interval;
mod lab;
mod packet;
mod plane;
mod scenes;
mod search;
mod sphere;
mod triangle;
mod world;

pub use axis_aligned_box::AxisAlignedBox;
pub use bounds::Bounds;
pub use geometry::Geometry;
pub use hit::Hit;
pub use interval::Interval;
#[doc(hidden)]
pub use lab::protocol;
pub use packet::PacketHit;
pub use plane::Plane;
pub use scenes::stage;
pub use search::{Hits, Search};
pub use sphere::Sphere;
pub use triangle::Triangle;
pub use world::World;

/// The code in this stage's chapter is tested with it.
#[cfg(doctest)]
#[doc = include_str!("../../book/src/a04-intersections.md")]
mod book {}
