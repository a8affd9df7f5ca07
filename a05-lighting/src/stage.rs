//! `stage`: joins the scenes, renderers, experiments and extreme cases of this
//! stage for its program.

use a03_rays_cameras::fast::{plan as plan_of_engine, render_by_engine};
use a03_rays_cameras::render_view;
use common::tally;
use common::{ArgumentError, Renderer, Scene};
use measure::Stage;

use crate::fast;
use crate::lab::{all_work, counted, experiments, explain, extremes};
use crate::scenes::{
    View, lambert, lighting_1, phong, phong_directional, phong_spot, phong_spot_ambient,
};

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    Stage {
        name: "a05-lighting",
        about: "Lights and materials: Lambert and Phong",
        scenes: vec![
            scene("lighting-1", "four objects without light", lighting_1),
            scene("lambert", "matt, under a point light", lambert),
            scene("phong", "shiny, under a point light", phong),
            scene("phong-directional", "under a far light", phong_directional),
            scene("phong-spot", "in the cone of a spot light", phong_spot),
            scene(
                "phong-spot-ambient",
                "and a little light from everywhere",
                phong_spot_ambient,
            ),
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
        let world = match settings.renderer {
            Renderer::AllWork => all_work::world(world)?,
            _ => world,
        };
        let world = tally::wrapped(world, counted::world)?;
        render_view(camera, |ray| world.color_for(ray), settings, progress)
    })
    .planned(move |settings, _| {
        let (camera, world) = view()?;
        let plan = explain::scene(&world, settings);
        Ok(plan_of_engine(plan, fast::scene(&world), &camera, settings))
    })
}
