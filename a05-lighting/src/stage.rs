//! `stage`: joins the scenes, renderers, experiments and extreme cases of this
//! stage for its program.

use a03_rays_cameras::Ray;
use a03_rays_cameras::fast::{plan as plan_of_engine, render_by_engine, render_by_lesson};
use common::{ArgumentError, Renderer, Scene};
use measure::{Stage, tally};

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
        let does_all_work = settings.renderer == Renderer::AllWork;
        let world = if does_all_work {
            all_work::world(world)?
        } else {
            world
        };
        let (camera, world) = tally::wrapped((camera, world), |(camera, world)| {
            Ok((
                a03_rays_cameras::counted::camera(camera, settings),
                counted::world(world)?,
            ))
        })?;
        let radiance = |ray: &Ray| world.color_for(ray);
        if does_all_work {
            a03_rays_cameras::all_work::render(&camera, radiance, settings, progress)
        } else {
            render_by_lesson(&camera, radiance, settings, progress)
        }
    })
    .planned(move |settings| {
        let (camera, world) = view()?;
        let plan = explain::scene(&world, settings);
        Ok(plan_of_engine(plan, fast::scene(&world), &camera, settings))
    })
}
