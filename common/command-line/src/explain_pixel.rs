//! `explain`: every number behind a pixel, by the lesson's own functions.

use std::path::PathBuf;

use common::steps::{Outcome, StepKind};
use common::{Color, Error, PixelTrace, Renderer, Scene, Settings};

use crate::explained_pixel::trace_in_words;
use crate::options::{MAX_EXPLAINED_SAMPLES, Options};
use crate::print::{print, warn};
use crate::render::{render, warn_unused};
use crate::target::{Replace, check_text, write_text};

/// How a pixel is explained.
#[derive(clap::Args)]
pub struct ExplainArgs {
    /// Column and row of the pixel, counted from 0 in the upper left corner
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true, value_parser = pixel)]
    pixel: [u32; 2],

    /// Print JSON, for programs
    #[arg(long, conflicts_with = "beside")]
    json: bool,

    /// Print only the rays and what they hit, and no colour: the rest can be computed from them
    #[arg(long, conflicts_with_all = ["json", "beside"])]
    rays: bool,

    /// Write an SVG of the first sample's rays, from the side and from above
    #[arg(long, value_name = "FILE")]
    drawing: Option<PathBuf>,

    #[command(flatten)]
    other: Replace,

    /// Find the first step at which the renderer of --fast or --no-omit parts from the lesson
    #[arg(long)]
    beside: bool,

    #[command(flatten)]
    options: Options,
}

fn pixel(text: &str) -> Result<[u32; 2], String> {
    let numbers = text.split_once(',');
    match numbers.map(|(x, y)| (x.trim().parse(), y.trim().parse())) {
        Some((Ok(x), Ok(y))) => Ok([x, y]),
        _ => Err("two whole numbers are needed, column and row, such as 320,240".to_owned()),
    }
}

/// Lists every number behind a pixel of the scene, and compares its colour with the rendered picture.
pub fn explain(scene: &Scene, arguments: &ExplainArgs) -> Result<(), Error> {
    let (options, settings) = (&arguments.options, arguments.options.settings(scene)?);
    let pixel @ [x, y] = arguments.pixel;
    check(&settings, pixel, arguments)?;
    let rays = scene.rays()?;
    if let Some(path) = &arguments.drawing {
        check_text(path, "svg", scene, options)?;
    }
    warn_unused(scene, options, &settings);
    let mut traced = settings.clone();
    if arguments.beside || settings.renderer == Renderer::Engine {
        traced.renderer = Renderer::Lesson;
    }
    let trace = rays.trace(&traced, pixel)?;
    let color = trace.color;
    if arguments.rays {
        return print(&rays_and_hits(&trace).to_string());
    }
    print(&if arguments.json {
        trace.to_json(options.transfer)
    } else {
        trace_in_words(scene, &settings, &trace)
    })?;
    if let Some(path) = &arguments.drawing {
        let drawing = rays.drawing(&settings, &trace, scene.name)?;
        write_text(path, &drawing, &arguments.other)?;
    }
    if arguments.beside {
        let other = rays.trace(&settings, pixel)?;
        let parts = trace.first_divergence(&other, "the other renderer's", 0.0);
        let equal = "the other renderer has the same numbers in each step that both take";
        print(&parts.map_or(equal.to_owned(), |parts| parts.to_string()))?;
    }
    let mut compared = settings;
    if scene.is_large {
        // The lesson takes minutes for the other pixels.
        compared.renderer = Renderer::Engine;
    }
    let rendered = render(scene, &compared, options, |_| Ok(()))?.get(x, y);
    if rendered != Some(color) {
        let (rendered, color) = (rendered.map(Color::channels), color.channels());
        warn(&format!(
            "warning: the rendered picture has another colour: {rendered:?}, not {color:?}"
        ));
    } else if !arguments.json {
        print("the rendered picture has the same colour, to the last bit")?;
    }
    Ok(())
}

/// The steps that send a ray or find a hit.
fn rays_and_hits(trace: &PixelTrace) -> PixelTrace {
    let mut rays = trace.clone();
    rays.steps.retain(|step| match step.kind {
        StepKind::CameraRay | StepKind::ShadowRay | StepKind::ReflectedRay | StepKind::Hit => true,
        StepKind::Test => step.outcome == Outcome::Hit,
        _ => false,
    });
    rays
}

/// An error if a pixel cannot be explained with these settings.
fn check(settings: &Settings, [x, y]: [u32; 2], arguments: &ExplainArgs) -> Result<(), Error> {
    let size = settings.size;
    let [right, bottom] = [size.width() - 1, size.height() - 1];
    let reason = if settings.max_error.is_some() {
        "--max-error chooses samples for a whole picture; explain takes --samples".to_owned()
    } else if x > right || y > bottom {
        format!(
            "--pixel {x},{y} is outside of the picture, whose pixels are 0,0 to {right},{bottom}"
        )
    } else if settings.samples > MAX_EXPLAINED_SAMPLES {
        format!("explain follows at most {MAX_EXPLAINED_SAMPLES} samples")
    } else if arguments.beside && settings.renderer == Renderer::Lesson {
        "--beside compares with another renderer; add --fast or --no-omit".to_owned()
    } else {
        return Ok(());
    };
    Err(Error::Usage(reason))
}

#[cfg(test)]
mod tests {
    use common::steps::Step;

    use super::*;

    #[test]
    fn rays_and_hits_have_no_colour() {
        let step = |kind, name: &str, outcome| Step {
            outcome,
            ..Step::new(kind, name.to_owned(), "page")
        };
        let trace = PixelTrace {
            pixel: [0, 0],
            color: Color::BLACK,
            steps: vec![
                step(StepKind::CameraRay, "ray", Outcome::None),
                step(StepKind::Test, "beside", Outcome::Missed),
                step(StepKind::Test, "ball", Outcome::Hit),
                step(StepKind::Hit, "hit", Outcome::None),
                step(StepKind::Light, "lamp", Outcome::None),
                step(StepKind::Color, "colour", Outcome::None),
                step(StepKind::ReflectedRay, "mirrored", Outcome::None),
            ],
        };
        let rays = rays_and_hits(&trace);
        let names: Vec<_> = rays.steps.iter().map(|step| &*step.name).collect();
        assert_eq!(names, ["ray", "ball", "hit", "mirrored"]);
    }
}
