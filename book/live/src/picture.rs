//! Renders the pictures of the book for its pages, and looks along single rays.

use a02_math::Vector3;
use a03_rays_cameras::{Camera, View, camera_coordinates};
use common::{Color, Error, Sampling, Settings};

use crate::exchange::settings;
use crate::turned::{Turn, Turned};
use crate::view::{centre, meet, view};
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
    let (column, row) = (*column as u32, *row as u32);
    let row = row.min(settings.size.height() - 1);
    let (x, y) = camera_coordinates(settings.size, column, row, (0.5, 0.5));
    let ray = view.camera.ray_for(settings.size, x, y);
    let Color { r, g, b } = view.world.radiance(&ray, settings.depth);
    let Some(met) = meet(&view, &ray) else {
        return Ok(Answer::text("the background").with("color", [r, g, b]));
    };
    let normal = Vector3::from(met.hit.normal).to_glam().to_array();
    let point = ray.at(met.hit.t).to_glam().to_array();
    Ok(Answer::text(met.names)
        .with("color", [r, g, b])
        .with("t", [met.hit.t])
        .with("point", point)
        .with("normal", normal))
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
