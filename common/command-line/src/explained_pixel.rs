//! `ExplainedPixel`: the numbers behind a pixel, for a person who clicks on it.

use common::pixel_trace::digits;
use common::steps::{Outcome, StepKind};
use common::{Color, Error, Picture, PixelTrace, Renderer, Sampling, Scene, SeenLine, Settings};

use crate::options::MAX_CLICKED_SAMPLES;

/// A pixel with its rays.
pub struct ExplainedPixel {
    /// Column and row.
    pub pixel: [u32; 2],
    /// Its object, if rays hit one.
    pub object: Option<String>,
    /// Its colour by the samples that were followed.
    pub color: Color,
    /// Its rays after the camera's, as the camera sees them.
    pub rays: Vec<SeenLine>,
    /// All numbers, as `explain` prints them.
    pub text: String,
}

impl ExplainedPixel {
    /// Follows the rays of a pixel by the lesson. A painted picture has none, only this colour.
    pub fn new(
        scene: &Scene,
        mut settings: Settings,
        pixel: [u32; 2],
        color: Color,
    ) -> Result<Self, Error> {
        let Picture::Traced(traced) = &scene.picture else {
            return Ok(Self {
                pixel,
                object: None,
                color,
                rays: Vec::new(),
                text: in_words(scene, &settings, pixel, "", color),
            });
        };
        let is_one_of_many = settings.max_error.is_some() || settings.samples > MAX_CLICKED_SAMPLES;
        if is_one_of_many {
            settings.max_error = None;
            (settings.samples, settings.sampling) = (1, Sampling::Center);
        }
        settings.renderer = Renderer::Lesson;
        let trace = traced.trace(&settings, pixel)?;
        let mut text = trace_in_words(scene, &settings, &trace);
        if is_one_of_many {
            text += "\nonly a sample in the middle of the pixel, which stands for all of them";
        }
        Ok(Self {
            pixel,
            object: first_object(&trace),
            color: trace.color,
            rays: traced.seen_rays(&settings, &trace)?,
            text,
        })
    }
}

/// The object that the ray from the camera hits first.
fn first_object(trace: &PixelTrace) -> Option<String> {
    let mut steps = trace.steps.iter();
    let first = steps.find(|step| step.kind == StepKind::Test && step.outcome == Outcome::Hit);
    first.map(|step| step.name.clone())
}

/// All numbers behind a pixel, and its colour.
pub fn trace_in_words(scene: &Scene, settings: &Settings, trace: &PixelTrace) -> String {
    let steps = format!("{trace}\n");
    in_words(scene, settings, trace.pixel, &steps, trace.color)
}

fn in_words(
    scene: &Scene,
    settings: &Settings,
    [x, y]: [u32; 2],
    steps: &str,
    color: Color,
) -> String {
    let (name, size) = (scene.name, settings.size);
    let bytes = settings.transfer.bytes(color);
    let linear = digits(&color.channels());
    format!("{name} {size}, pixel {x},{y}\n{steps}bytes {bytes:?} of the linear colour {linear}")
}
