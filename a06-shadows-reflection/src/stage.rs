//! `stage`: joins the scenes, renderers, experiments and extreme cases of this
//! stage for its program.

use a03_rays_cameras::{Ray, render};
use common::{ArgumentError, Renderer, Scene, Settings};
use measure::{Stage, tally};

use crate::RecursiveTracer;
use crate::lab::all_work::{self, NaiveTracer};
use crate::lab::{counted, experiments, explain, extremes};
use crate::scenes::{View, aab, sphere};

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    Stage {
        name: "a06-shadows-reflection",
        about: "Shadows and mirrors",
        scenes: vec![
            traced_scene("sphere", "three mirroring spheres on a mirror", sphere).reflecting(),
            traced_scene("aab", "a box and its shadow", aab),
        ],
        experiments: experiments::experiments,
        extremes: extremes::cases,
    }
}

/// A scene that the recursive tracer shows.
pub fn traced_scene(
    name: &'static str,
    about: &'static str,
    view: impl Fn() -> Result<View, ArgumentError> + Copy + Send + Sync + 'static,
) -> Scene {
    Scene::traced(name, about, move |settings, progress| {
        let (camera, world) = view()?;
        match settings.renderer {
            Renderer::Lesson | Renderer::Engine => {
                let (camera, world) = counting((camera, world), settings)?;
                let tracer = RecursiveTracer::new(&world);
                let radiance = |ray: &Ray| tracer.trace(ray, settings.depth);
                render(&camera, radiance, settings, progress)
            }
            Renderer::AllWork => {
                let (camera, world) = counting((camera, all_work::world(world)?), settings)?;
                let tracer = NaiveTracer::new(&world);
                let radiance = |ray: &Ray| tracer.trace(ray, settings.depth);
                a03_rays_cameras::all_work::render(&camera, radiance, settings, progress)
            }
        }
    })
    .planned(move |settings| Ok(explain::traced(&view()?.1, settings)))
}

/// The same camera and world, which count their work if it is to be counted.
fn counting((camera, world): View, settings: &Settings) -> Result<View, ArgumentError> {
    if !tally::is_on() {
        return Ok((camera, world));
    }
    Ok((counted::camera(camera, settings), counted::world(world)?))
}
