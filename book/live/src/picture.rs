//! Renders the pictures of the book for its pages, and looks along single rays.

use a03_rays_cameras::View;
use common::steps::{HIT, TEST};
use common::{Error, Sampling, Settings};

use crate::exchange::settings;
use crate::turned::{Turn, Turned};
use crate::view::{centre, view};
use crate::{Answer, Answered, catalogue};

pub use crate::exchange::{pixels, sampling};

/// How far a page has turned the camera: yaw, pitch and zoom, after the settings.
fn turn(numbers: &[f64]) -> Turn {
    match *numbers {
        [_, _, _, _, _, _, _, yaw, pitch, zoom, ..] => Turn { yaw, pitch, zoom },
        _ => Turn::NONE,
    }
}

/// The view of a picture, with its camera turned.
fn turned(picture: &str, settings: &Settings, turn: Turn) -> Result<Option<View>, Error> {
    let view = view(picture, settings)?;
    Ok(view.map(|view| {
        if turn == Turn::NONE {
            return view;
        }
        let camera = Turned::new(view.camera, settings.size, centre(picture), turn);
        View::new(camera, view.world)
    }))
}

/// Renders a picture: its pixels, its size and, as text, the hash that the tests lock.
pub fn render(picture: &str, numbers: &[f64]) -> Answered {
    let scene = catalogue::scene(picture)?;
    let settings = settings(&scene.defaults, numbers)?;
    let image = match turned(picture, &settings, turn(numbers))? {
        Some(view) => view.render(&settings, &()),
        None => scene.render(&settings, &()),
    };
    image.map(|image| pixels(&image))
}

/// Looks along the ray through the middle of a pixel, whose column and row follow the
/// settings: its linear colour, and if it meets a surface, `t`, point and normal.
pub fn probe(picture: &str, numbers: &[f64]) -> Answered {
    let scene = catalogue::scene(picture)?;
    let settings = settings(&scene.defaults, numbers)?;
    let view = turned(picture, &settings, turn(numbers))?;
    let (Some(view), [.., column, row]) = (view, numbers) else {
        return Ok(Answer::text("painted, without a ray"));
    };
    let row = (*row as u32).min(settings.size.height() - 1);
    let settings = Settings {
        samples: 1,
        sampling: Sampling::Center,
        ..settings
    };
    let trace = view.trace(&settings, [*column as u32, row])?;
    let step = |kind| trace.steps.iter().find(|step| step.kind == kind);
    let name = |kind| step(kind).map_or("", |step| &step.name);
    let color = trace.color.channels();
    let Some(hit) = step(HIT) else {
        return Ok(Answer::text("the background").with("color", color));
    };
    let (_, object) = name(TEST).split_once(": ").unwrap_or_default();
    let material = name("color")
        .replace("colour of ", ", ")
        .replace("colour", "");
    Ok(Answer::text(format!("{object}{material}"))
        .with("color", color)
        .with("t", hit.value("t").unwrap_or([f64::NAN]))
        .with("point", hit.value("p").unwrap_or([f64::NAN; 3]))
        .with("normal", hit.value("n").unwrap_or([f64::NAN; 3])))
}

/// The settings that a picture has by default, and those that change it.
pub fn about(picture: &str) -> Answered {
    let scene = catalogue::scene(picture)?;
    let defaults = &scene.defaults;
    let mut places = Sampling::ALL.iter();
    let sampling = places.position(|place| *place == defaults.sampling);
    let turns = catalogue::traced_scene(picture).is_some();
    let flag = |is_set| f64::from(u8::from(is_set));
    let (width, height) = (defaults.size.width(), defaults.size.height());
    Ok(Answer::text(scene.about)
        .with("size", [width.into(), height.into()])
        .with("samples", [defaults.samples.into()])
        .with("sampling", [sampling.unwrap_or(0) as f64])
        .with("seed", [defaults.seed as f64])
        .with("depth", [defaults.depth.into()])
        .with("uses_sampling", [flag(scene.uses.sampling)])
        .with("uses_depth", [flag(scene.uses.depth)])
        .with("turns", [flag(turns)]))
}
