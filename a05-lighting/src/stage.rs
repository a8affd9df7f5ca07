//! `stage`: joins the scenes, renderers, experiments and extreme cases of this
//! stage for its program.

use a03_rays_cameras::{Camera, Ray, render};
use common::{ArgumentError, Scene, Stage, tally};

use crate::LitWorld;
use crate::lab::{all_work, counted, experiments, explain, extremes};
use crate::scenes::{
    camera, lambert, lighting_1, phong, phong_directional, phong_spot, phong_spot_ambient,
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
    world: fn() -> Result<LitWorld, ArgumentError>,
) -> Scene {
    Scene::traced(name, about, move |settings, progress| {
        let mut camera: Box<dyn Camera> = Box::new(camera()?);
        let mut world = world()?;
        if !settings.omit {
            world = all_work::world(world)?;
        }
        if tally::is_on() {
            camera = a03_rays_cameras::counted::camera(camera, settings);
            world = counted::world(world)?;
        }
        let radiance = |ray: &Ray| world.color_for(ray);
        if settings.omit {
            render(&camera, radiance, settings, progress)
        } else {
            a03_rays_cameras::all_work::render(&camera, radiance, settings, progress)
        }
    })
    .planned(move |settings| Ok(explain::scene(&world()?, settings)))
}
