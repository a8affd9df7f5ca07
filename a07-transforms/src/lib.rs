//! Assignment 7: translation, scaling and rotation of objects; the scene graph.
//!
//! A [`Transform`] transforms the ray instead of the object; a [`Node`] is a
//! geometry that does this for its children.

mod disc;
mod mat4x4;
mod node;
mod program;
#[doc(hidden)]
pub mod scenes;
mod transform;

pub use crate::program::{kinds, stage, traced};
pub use disc::Disc;
pub use mat4x4::Mat4x4;
pub use node::Node;
pub use transform::Transform;
