//! `stage`: joins the scenes, renderers, experiments and extreme cases of this
//! stage for its program.

use a03_rays_cameras::{Ray, render};
use common::{ArgumentError, Scene, Stage, tally};

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
        let (mut camera, mut world) = view()?;
        if !settings.omit {
            world = all_work::world(world)?;
        }
        if tally::is_on() {
            camera = counted::camera(camera, settings);
            world = counted::world(world)?;
        }
        if settings.omit {
            let tracer = RecursiveTracer::new(&world);
            let radiance = |ray: &Ray| tracer.trace(ray, settings.depth);
            render(&camera, radiance, settings, progress)
        } else {
            let tracer = NaiveTracer::new(&world);
            let radiance = |ray: &Ray| tracer.trace(ray, settings.depth);
            a03_rays_cameras::all_work::render(&camera, radiance, settings, progress)
        }
    })
    .planned(move |settings| Ok(explain::traced(&view()?.1, settings)))
}
