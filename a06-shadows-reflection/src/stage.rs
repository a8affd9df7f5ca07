//! `stage`: the scenes of this stage for its program, and its
//! world for the renderers.

use a03_rays_cameras::{Ray, TracedScene, TracedWorld, View};
use a04_intersections::instruments::objects;
use common::{Color, Stage};

use crate::scenes::{aab, sphere};
use crate::{RecursiveTracer, ShadowedWorld};

/// The traced scenes in the order of the course.
#[must_use]
pub fn scenes() -> [TracedScene; 2] {
    let new = TracedScene::new;
    [
        new("sphere", "three mirroring spheres on a mirror", |_| {
            sphere().map(traced)
        })
        .reflecting(),
        new("aab", "a box and its shadow", |_| aab().map(traced)),
    ]
}

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    Stage {
        name: "a06-shadows-reflection",
        about: "Shadows and mirrors",
        scenes: scenes().map(Into::into).into(),
        open: Some(|path| a03_rays_cameras::from_file::scene(path, 6, crate::from_file::view)),
    }
}

/// A view for the renderers, with geometries of this stage or a lower one.
#[must_use]
pub fn traced(view: View<ShadowedWorld>) -> View {
    let world = |world| RecursiveWorld {
        // The lesson needs nothing else.
        world,
        shapes: a04_intersections::fast::shapes,
        recorded: |geometry| geometry,
    };
    view.map(world).boxed()
}

/// A world that the [`RecursiveTracer`] renders, with two functions for its geometries, which
/// may be of a higher stage.
pub struct RecursiveWorld {
    /// The world.
    pub world: ShadowedWorld,
    /// Translates a geometry for the engine.
    pub shapes: a04_intersections::fast::Translate,
    /// Wraps a geometry to count its work.
    pub recorded: fn(Box<dyn a04_intersections::Geometry>) -> Box<dyn a04_intersections::Geometry>,
}

impl TracedWorld for RecursiveWorld {
    fn radiance(&self, ray: &Ray, depth: u32) -> Color {
        RecursiveTracer::new(&self.world).trace(ray, depth)
    }

    fn for_engine(&self, depth: u32) -> Option<engine::Scene<'_>> {
        Some(crate::fast::scene(&self.world, depth, self.shapes))
    }

    fn nearest(&self, ray: &Ray) -> Option<(usize, f64)> {
        objects::nearest(self.world.objects(), ray)
    }

    fn object_name(&self, number: usize) -> String {
        objects::object_name(self.world.objects(), number)
    }

    fn light_positions(&mut self) -> Vec<&mut a02_math::Point3> {
        a05_lighting::instruments::light_positions(&mut self.world, |source| &mut *source.light)
    }

    fn recorded(self: Box<Self>, all_work: bool) -> Box<dyn TracedWorld> {
        let Self {
            world, recorded, ..
        } = *self;
        Box::new(crate::instruments::recorded::RecordedWorld::new(
            world, recorded, all_work,
        ))
    }
}
