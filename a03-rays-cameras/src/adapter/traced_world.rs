//! `TracedWorld`: a world for every renderer.

use std::any::Any;

use common::Color;
use scene_export::{Values, WrittenLight, WrittenShape};

use super::instruments::Instruments;
use crate::{Ray, View};

/// A world that rays bring light from. Each stage implements it for its own type.
pub trait TracedWorld: Any + Send + Sync {
    /// The light that comes back along a ray that may hit `depth` surfaces in turn: the code
    /// of the lesson.
    fn radiance(&self, ray: &Ray, depth: u32) -> Color;

    /// The world in the numbers of the engine; none if the engine has no type for it.
    fn for_engine(&self, _depth: u32) -> Option<engine::Scene<'_>> {
        None
    }

    /// The shapes of the world as the values of their tables in a scene file, each with the
    /// number of its surface in the engine's scene.
    fn written_shapes(&self) -> Vec<WrittenShape> {
        Vec::new()
    }

    /// The materials of the engine's surfaces as the values of their tables; none of a type that has
    /// no table.
    fn written_materials(&self) -> Vec<Option<Values>> {
        Vec::new()
    }

    /// The lights of the world as the values of their tables, in the order of the engine's.
    fn written_lights(&self) -> Vec<WrittenLight> {
        Vec::new()
    }

    /// The number of the object, from 1, that a ray hits first, and the `t` of this hit.
    fn nearest(&self, _ray: &Ray) -> Option<(usize, f64)> {
        None
    }

    /// The name of the object of a number.
    fn object_name(&self, _number: usize) -> String {
        String::new()
    }

    /// The same world with these instruments around its parts. The colours do not change.
    fn instrumented(self: Box<Self>, instruments: Instruments) -> Box<dyn TracedWorld>;
}

/// A world given by the light along each ray, for a background or a formula of its own.
impl<F: Fn(&Ray) -> Color + Send + Sync + 'static> TracedWorld for F {
    fn radiance(&self, ray: &Ray, _: u32) -> Color {
        self(ray)
    }

    fn instrumented(self: Box<Self>, _: Instruments) -> Box<dyn TracedWorld> {
        self
    }
}

impl<W: TracedWorld> View<W> {
    /// The same view for the renderers.
    #[must_use]
    pub fn boxed(self) -> View {
        self.map(|world| Box::new(world) as _)
    }
}
