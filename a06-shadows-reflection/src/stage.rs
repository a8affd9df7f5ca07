//! `stage`: joins the scenes, renderers, experiments and extreme cases of this
//! stage for its program.

use a03_rays_cameras::Ray;
use a03_rays_cameras::fast::{plan as plan_of_engine, render_by_engine, render_by_lesson};
use a04_intersections::fast::{Translate, shapes};
use common::tally;
use common::{ArgumentError, Renderer, Scene, Settings};
use measure::Stage;

use crate::lab::all_work::{self, NaiveTracer};
use crate::lab::{counted, experiments, explain, extremes};
use crate::scenes::{View, aab, sphere};
use crate::{RecursiveTracer, fast};

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    Stage {
        name: "a06-shadows-reflection",
        about: "Shadows and mirrors",
        scenes: vec![
            traced_scene(
                "sphere",
                "three mirroring spheres on a mirror",
                |_| sphere(),
                shapes,
            )
            .reflecting(),
            traced_scene("aab", "a box and its shadow", |_| aab(), shapes),
        ],
        experiments: experiments::experiments,
        extremes: extremes::cases,
    }
}

/// A scene for the recursive tracer. `shapes` translates its geometries for the engine.
pub fn traced_scene(
    name: &'static str,
    about: &'static str,
    view: impl Fn(&Settings) -> Result<View, ArgumentError> + Copy + Send + Sync + 'static,
    shapes: Translate,
) -> Scene {
    Scene::traced(name, about, move |settings, progress| {
        let (camera, world) = view(settings)?;
        let counting = |view| {
            tally::wrapped(view, |(camera, world)| {
                Ok((counted::camera(camera, settings), counted::world(world)?))
            })
        };
        match settings.renderer {
            Renderer::Lesson => {
                let (camera, world) = counting((camera, world))?;
                let tracer = RecursiveTracer::new(&world);
                let radiance = |ray: &Ray| tracer.trace(ray, settings.depth);
                render_by_lesson(&camera, radiance, settings, progress)
            }
            Renderer::Engine => {
                let scene = fast::scene(&world, settings.depth, shapes);
                render_by_engine(scene, &camera, settings, progress)
            }
            Renderer::AllWork => {
                let (camera, world) = counting((camera, all_work::world(world)?))?;
                let tracer = NaiveTracer::new(&world);
                let radiance = |ray: &Ray| tracer.trace(ray, settings.depth);
                a03_rays_cameras::all_work::render(&camera, radiance, settings, progress)
            }
        }
    })
    .planned(move |settings, _| {
        let (camera, world) = view(settings)?;
        let plan = explain::traced(&world, settings);
        let scene = fast::scene(&world, settings.depth, shapes);
        Ok(plan_of_engine(plan, scene, &camera, settings))
    })
}
