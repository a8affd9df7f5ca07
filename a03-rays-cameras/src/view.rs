//! `View`: a camera and the world before it.

use crate::{Camera, TracedWorld};

/// A camera and the world before it.
///
/// The functions of a stage's `scenes.rs` return the world in its own type. The renderers
/// take any [`TracedWorld`].
pub struct View<W = Box<dyn TracedWorld>> {
    /// The camera.
    pub camera: Box<dyn Camera>,
    /// The world.
    pub world: W,
}

impl<W> View<W> {
    /// A view of this world.
    pub fn new(camera: impl Camera, world: W) -> Self {
        Self {
            camera: Box::new(camera),
            world,
        }
    }

    /// The same camera before the world that this function makes of the world.
    pub fn map<V>(self, world: impl FnOnce(W) -> V) -> View<V> {
        View {
            camera: self.camera,
            world: world(self.world),
        }
    }
}
