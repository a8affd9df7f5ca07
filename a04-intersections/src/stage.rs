//! `stage`: joins the scenes, renderers, experiments and extreme cases of this
//! stage for its program.

use a03_rays_cameras::fast::{plan as plan_of_engine, render_by_engine};
use a03_rays_cameras::render_view;
use common::tally;
use common::{ArgumentError, Renderer, Scene};
use measure::Stage;

use crate::fast;
use crate::lab::{counted, experiments, explain, extremes};
use crate::scenes::{View, scene_1, scene_2, scene_3, scene_4, scene_5, scene_6};

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    Stage {
        name: "a04-intersections",
        about: "Where rays meet planes, boxes, triangles and spheres",
        scenes: vec![
            scene("scene-1", "a green plane, up to the horizon", scene_1),
            scene("scene-2", "a red sphere", scene_2),
            scene("scene-3", "a blue box, from above its corner", scene_3),
            scene("scene-4", "a magenta triangle", scene_4),
            scene("scene-5", "two red spheres, one farther away", scene_5),
            scene("scene-6", "the same without perspective", scene_6),
        ],
        experiments: experiments::experiments,
        extremes: extremes::cases,
    }
}

fn scene(
    name: &'static str,
    about: &'static str,
    view: fn() -> Result<View, ArgumentError>,
) -> Scene {
    Scene::traced(name, about, move |settings, progress| {
        let (camera, world) = view()?;
        if settings.renderer == Renderer::Engine {
            return render_by_engine(fast::scene(&world), &camera, settings, progress);
        }
        let world = tally::wrapped(world, counted::world)?;
        render_view(camera, |ray| world.color_for(ray), settings, progress)
    })
    .planned(move |settings, _| {
        let (camera, world) = view()?;
        let plan = explain::colors(&world, settings);
        Ok(plan_of_engine(plan, fast::scene(&world), &camera, settings))
    })
}
