//! `stage`: the scenes of this stage for its program, and its
//! world for the renderers.

use a03_rays_cameras::instruments::Instruments;
use a03_rays_cameras::{Ray, TracedWorld, View, traced_scene};
use a04_intersections::instruments::objects;
use a04_intersections::registry::{ALL_SHAPES, Shapes};
use a05_lighting::registry::LIGHTS;
use common::{Color, Stage};
use scene_export::{Values, WrittenLight, WrittenShape};

use crate::instruments::instrumented::InstrumentedWorld;
use crate::scenes::{aab, sphere};
use crate::{RecursiveTracer, ShadowedWorld, registry};

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    let new = traced_scene;
    let scenes = vec![
        new("sphere", "three mirroring spheres on a mirror", |_| {
            sphere().map(traced)
        })
        .reflecting(),
        new("aab", "a box and its shadow", |_| aab().map(traced)),
    ];
    Stage {
        name: "a06-shadows-reflection",
        about: "Shadows and mirrors",
        scenes,
        open: Some(|path| registry::FORMAT.open(path)),
    }
}

/// A view for the renderers, with shapes of this stage or a lower one.
#[must_use]
pub fn traced(view: View<ShadowedWorld>) -> View {
    traced_with(view, ALL_SHAPES)
}

/// A view for the renderers, whose world may have these shapes.
#[must_use]
pub fn traced_with(view: View<ShadowedWorld>, shapes: Shapes) -> View {
    view.map(|world| RecursiveWorld { world, shapes }).boxed()
}

/// A world that the [`RecursiveTracer`] renders, and the shapes that it may have.
pub struct RecursiveWorld {
    /// The world.
    pub world: ShadowedWorld,
    /// The rows of its shapes, which may be of a higher stage.
    pub shapes: Shapes,
}

impl TracedWorld for RecursiveWorld {
    fn radiance(&self, ray: &Ray, depth: u32) -> Color {
        RecursiveTracer::new(&self.world).trace(ray, depth)
    }

    fn for_engine(&self, depth: u32) -> Option<engine::Scene<'_>> {
        Some(registry::for_engine(&self.world, depth, self.shapes))
    }

    fn written_shapes(&self) -> Vec<WrittenShape> {
        self.shapes.written(self.world.objects())
    }

    fn written_materials(&self) -> Vec<Option<Values>> {
        let objects = self.world.objects().objects();
        objects
            .map(|(_, surface)| registry::ALL_MATERIALS.written(&**surface))
            .collect()
    }

    fn written_lights(&self) -> Vec<WrittenLight> {
        let sources = self.world.lights().iter();
        sources
            .map(|source| LIGHTS.written(&*source.light))
            .collect()
    }

    fn nearest(&self, ray: &Ray) -> Option<(usize, f64)> {
        objects::nearest(self.world.objects(), ray)
    }

    fn object_name(&self, number: usize) -> String {
        objects::object_name(self.world.objects(), number)
    }

    fn instrumented(self: Box<Self>, instruments: Instruments) -> Box<dyn TracedWorld> {
        let instrumented = InstrumentedWorld::new(self.world, self.shapes, instruments);
        Box::new(instrumented)
    }
}
