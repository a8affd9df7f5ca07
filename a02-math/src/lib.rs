//! Assignment 2: the mathematics of rays, kept apart by meaning.
//!
//! [`Point3`] is a position, [`Vector3`] the step from one point to another,
//! [`Normal3`] the direction that a surface faces. Each wraps three numbers of
//! glam; meaningless operations, like the sum of two points, do not compile.

mod adapter;
mod direction;
#[doc(hidden)]
pub mod mat3x3;
mod normal3;
mod point3;
mod scenes;
mod triple;
mod vector3;

#[doc(hidden)]
pub use crate::adapter::arrays;
pub use crate::adapter::stage;
pub use direction::Direction;
pub use mat3x3::Mat3x3;
pub use normal3::Normal3;
pub use point3::Point3;
pub use vector3::Vector3;
