//! `stage`: the scenes, experiments and extreme cases of this stage for its program, and its
//! world for the renderers.

use a03_rays_cameras::{Ray, TracedScene, TracedWorld, View, from_file};
use a04_intersections::Geometry;
use a04_intersections::fast::{Translate, shapes};
use common::Color;
use measure::Stage;

use crate::lab::watched::WatchedWorld;
use crate::lab::{experiments, extremes};
use crate::scenes::{aab, sphere};
use crate::{RecursiveTracer, ShadowedWorld, fast};

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
        experiments: experiments::experiments,
        extremes: extremes::cases,
        search: None,
        open: Some(|path| from_file::scene(path, 6, crate::from_file::view)),
    }
}

/// A view for the renderers, with geometries of this stage or a lower one.
#[must_use]
pub fn traced(view: View<ShadowedWorld>) -> View {
    let world = |world| RecursiveWorld {
        world,
        shapes,
        watched: |geometry| geometry,
    };
    view.map(world).boxed()
}

/// A world that the [`RecursiveTracer`] renders, with two functions for its geometries, which
/// may be of a higher stage.
pub struct RecursiveWorld {
    /// The world.
    pub world: ShadowedWorld,
    /// Translates a geometry for the engine.
    pub shapes: Translate,
    /// Wraps a geometry to count its work.
    pub watched: fn(Box<dyn Geometry>) -> Box<dyn Geometry>,
}

impl TracedWorld for RecursiveWorld {
    fn radiance(&self, ray: &Ray, depth: u32) -> Color {
        RecursiveTracer::new(&self.world).trace(ray, depth)
    }

    fn for_engine(&self, depth: u32) -> Option<engine::Scene<'_>> {
        Some(fast::scene(&self.world, depth, self.shapes))
    }

    fn watched(self: Box<Self>, all_work: bool) -> Box<dyn TracedWorld> {
        Box::new(WatchedWorld::new(self.world, self.watched, all_work))
    }
}
