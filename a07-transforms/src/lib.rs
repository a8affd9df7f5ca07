//! Assignment 7: translation, scaling and rotation of objects; the scene graph.
//!
//! A [`Transform`] transforms the ray instead of the object; a [`Node`] is a
//! geometry that does this for its children.

mod adapter;
mod disc;
mod mat4x4;
mod node;
#[doc(hidden)]
pub mod scenes;
mod transform;

pub use crate::adapter::{registry, stage, traced};
pub use disc::Disc;
pub use mat4x4::Mat4x4;
pub use node::Node;
pub use transform::Transform;
