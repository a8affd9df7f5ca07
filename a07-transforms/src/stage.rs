//! `stage`: joins the scenes, renderers, experiments and extreme cases of this
//! stage for its program.

use a06_shadows_reflection::{View, traced_scene};
use common::tally;
use common::{ArgumentError, Renderer, Scene, Settings};
use measure::Stage;

use crate::fast::shapes;
use crate::lab::{counted, experiments, explain, extremes};
use crate::scenes::{box_transformations, disc, sphere_transformation};

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    let ellipsoid = "a sphere, stretched to an ellipsoid";
    let turned = "a box, stretched and turned three times";
    Stage {
        name: "a07-transforms",
        about: "Transformed geometry, the scene graph and the disc",
        scenes: vec![
            scene("sphere-transformation", ellipsoid, sphere_transformation),
            scene("box-transformations", turned, box_transformations),
            scene("disc", "a disc on a mirroring plane", disc).reflecting(),
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
    // The engine has counters of its own.
    let counted_view = move |settings: &Settings| match settings.renderer {
        Renderer::Engine => view(),
        Renderer::Lesson | Renderer::AllWork => tally::wrapped(view()?, |(camera, world)| {
            Ok((camera, counted::world(world)?))
        }),
    };
    traced_scene(name, about, counted_view, shapes)
        .planned(move |_, plan| Ok(explain::nodes(plan, &view()?.1)))
}
