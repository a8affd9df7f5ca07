//! Assignment 7: translation, scaling and rotation of objects; the scene graph.
//!
//! A [`Transform`] transforms the ray instead of the object; a [`Node`] is a
//! geometry that does this for its children.

mod disc;
pub mod kinds;
mod mat4x4;
mod node;
#[doc(hidden)]
pub mod scenes;
mod stage;
mod transform;

pub use disc::Disc;
pub use mat4x4::Mat4x4;
pub use node::Node;
pub use stage::{scenes as traced_scenes, stage, traced};
pub use transform::Transform;
