//! Renders the pictures of the book for its pages, and takes the numbers behind a pixel.

use a03_rays_cameras::instruments::orbit_camera::{Orbit, OrbitCamera};
use a03_rays_cameras::{View, Views};
use common::{Error, PixelTrace, Renderer, Sampling, Settings, Transfer};

use crate::{Answered, Reply, catalogue};

use page::settings;
pub use page::{pixels, sampling};

/// How far a page has rotated the camera: yaw, pitch and zoom, after the settings.
fn orbit(numbers: &[f64]) -> Orbit {
    match *numbers {
        [_, _, _, _, _, _, _, yaw, pitch, zoom, ..] => Orbit { yaw, pitch, zoom },
        _ => Orbit::NONE,
    }
}

/// The settings in the numbers of a page, and the view of a picture with its camera rotated; none
/// if the picture is painted without rays.
fn view(picture: &str, numbers: &[f64]) -> Result<(Settings, Option<View>), Error> {
    let settings = settings(&catalogue::scene(picture)?.defaults, numbers)?;
    let (view, orbit) = (catalogue::view(picture, &settings)?, orbit(numbers));
    let view = view.map(|view| {
        if orbit == Orbit::NONE {
            return view;
        }
        let centre = catalogue::centre(picture);
        let camera = OrbitCamera::new(view.camera, settings.size, centre, orbit);
        View::new(camera, view.world)
    });
    Ok((settings, view))
}

/// Renders a picture: its pixels, its size and, as text, the hash that the tests lock.
pub fn render(picture: &str, numbers: &[f64]) -> Answered {
    let image = match view(picture, numbers)? {
        (settings, Some(view)) => view.render(&settings, &()),
        (settings, None) => catalogue::scene(picture)?.render(&settings, &()),
    };
    image.map(|image| pixels(&image))
}

/// The numbers behind a pixel, whose column and row follow the settings.
fn traced(picture: &str, numbers: &[f64]) -> Result<PixelTrace, Error> {
    let (settings, view) = view(picture, numbers)?;
    let pixel = match numbers.get(10..12) {
        Some(&[column, row]) => [column, row].map(|place| place as u32),
        _ => [u32::MAX; 2],
    };
    if pixel[0] >= settings.size.width() || pixel[1] >= settings.size.height() {
        let size = settings.size;
        return Err(Error::Usage(format!("the pixel is not in {size} pixels")));
    }
    let painted = || Error::Usage("a painted picture has no rays".to_owned());
    // The engine, which draws the files, takes no steps.
    let settings = Settings {
        renderer: Renderer::Lesson,
        ..settings
    };
    Ok(view.ok_or_else(painted)?.trace(&settings, pixel))
}

/// The numbers behind a pixel as JSON.
pub fn trace(picture: &str, numbers: &[f64]) -> Answered {
    traced(picture, numbers).map(|trace| Reply::text(trace.to_json(Transfer::Linear)))
}

/// The rays of a sample, whose number from 0 follows the pixel, as SVG, and the places of its views.
pub fn drawing(picture: &str, numbers: &[f64]) -> Answered {
    let steps = traced(picture, numbers)?.steps;
    let sample = numbers.get(12).map_or(0, |sample| *sample as usize);
    let sample = steps.chunk_by(|_, next| next.level > 0).nth(sample);
    let (_, view) = view(picture, numbers)?;
    let painted = || Error::Usage("a painted picture has no rays".to_owned());
    let drawing = view
        .ok_or_else(painted)?
        .drawing(sample.unwrap_or_default(), "the picture");
    Ok(Reply::text(drawing.svg).with("views", drawing.views.into_iter().flatten()))
}

/// The scene of a picture as a scene file.
pub fn export(picture: &str) -> Answered {
    let scene = catalogue::scene(picture)?;
    let text = Views::of(&scene)?
        .view(&scene.defaults)?
        .export("toml", &scene.defaults)?;
    Ok(Reply::text(text))
}

/// The settings that a picture has by default, and those that change it.
pub fn about(picture: &str) -> Answered {
    let scene = catalogue::scene(picture)?;
    let defaults = &scene.defaults;
    let mut places = Sampling::ALL.iter();
    let sampling = places.position(|place| *place == defaults.sampling);
    let turns = catalogue::view(picture, defaults)?.is_some();
    let flag = |is_set| f64::from(u8::from(is_set));
    let engine = flag(defaults.renderer == Renderer::Engine);
    let [width, height] = [defaults.size.width(), defaults.size.height()].map(f64::from);
    let (samples, place) = (defaults.samples.into(), sampling.unwrap_or(0) as f64);
    let (seed, depth) = (defaults.seed as f64, defaults.depth.into());
    Ok(Reply::text(scene.about)
        .with(
            "settings",
            [width, height, samples, place, seed, depth, engine],
        )
        .with("uses_sampling", [flag(scene.uses.sampling)])
        .with("uses_depth", [flag(scene.uses.depth)])
        .with("turns", [flag(turns)]))
}
