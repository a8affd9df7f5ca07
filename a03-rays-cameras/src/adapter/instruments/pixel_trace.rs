//! The numbers behind a pixel of a view.

use common::steps::{self, Step, StepKind, trace_chosen};
use common::{Color, Error, Image, Omissions, PixelTrace, Renderer, Settings};

use super::Instruments;
use super::instrumented::push_ray;
use crate::{Camera, Ray, Sampler, View, camera_coordinates, registry, render};

const SAMPLES: &str = "a03-rays-cameras.md#many-rays-per-pixel";
const LOOP: &str = "a03-rays-cameras.md#the-only-loop";
const MIRRORS: &str = "a06-shadows-reflection.md#how-deep";

impl View {
    /// The linear colour of a pixel by the lesson: the mean of its samples.
    #[must_use]
    pub fn color(&self, settings: &Settings, [column, row]: [u32; 2]) -> Color {
        let (size, sampler) = (settings.size, Sampler::new(settings));
        let mut sum = Color::BLACK;
        for place in sampler.places(column, row) {
            let (x, y) = camera_coordinates(size, column, row, place);
            let ray = self.camera.ray_for(size, x, y);
            sum += self.world.radiance(&ray, settings.depth);
        }
        sum / f64::from(sampler.samples())
    }

    /// The steps from a pixel, whose column and row lie in the picture, to its colour, by the
    /// renderer of the settings. The engine takes only the steps of the loop over the samples.
    #[must_use]
    pub fn trace(self, settings: &Settings, pixel: [u32; 2]) -> PixelTrace {
        if settings.renderer == Renderer::Engine
            && let Some(scene) = self.world.for_engine(settings.depth)
        {
            let light = registry::light_at(scene, &*self.camera, settings);
            return trace_samples(settings, pixel, light);
        }
        let omissions = match settings.renderer {
            Renderer::NoOmissions => Omissions::NONE,
            Renderer::Lesson | Renderer::Engine => Omissions::ALL,
        };
        let view = self.instrumented(Instruments::Report(omissions));
        trace_samples(settings, pixel, |x, y| {
            let ray = view.camera.ray_for(settings.size, x, y);
            view.world.radiance(&ray, settings.depth)
        })
    }
}

/// The steps from a pixel to the mean of the light at the places of its samples.
fn trace_samples(
    settings: &Settings,
    pixel: [u32; 2],
    light: impl Fn(f64, f64) -> Color,
) -> PixelTrace {
    let ([column, row], size, sampler) = (pixel, settings.size, Sampler::new(settings));
    let (color, steps) = steps::traced(|| {
        let mut sum = Color::BLACK;
        for (i, place) in (1..).zip(sampler.places(column, row)) {
            let (x, y) = camera_coordinates(size, column, row, place);
            let sample = |kind| {
                let name = format!("sample {i} of {}", sampler.samples());
                Step::new(kind, name, SAMPLES)
                    .numbered(i)
                    .with("place", [place.0, place.1])
                    .with("x", [x])
                    .with("y", [y])
            };
            sum += steps::inside(StepKind::Sample, 1, sample, || {
                let light = light(x, y);
                let is_reflected = |step: &Step| step.kind == StepKind::ReflectedRay;
                let mirrors = steps::so_far(|steps| steps.iter().any(is_reflected));
                let section = if mirrors == Some(true) { MIRRORS } else { LOOP };
                steps::heading(StepKind::Radiance, |kind| {
                    Step::new(kind, "light along the ray", section).with("f", light.channels())
                });
                light
            });
        }
        let mean = sum / f64::from(sampler.samples());
        steps::push(StepKind::Mean, |kind| {
            Step::new(kind, "mean of the samples", LOOP).with("c", mean.channels())
        });
        mean
    });
    PixelTrace {
        pixel,
        color,
        steps,
    }
}

/// Renders a picture, as [`render`], and traces its chosen pixel: for code that is not in the
/// lesson, such as that of exercises.
pub fn paint(
    camera: &dyn Camera,
    radiance: &(dyn Fn(&Ray) -> Color + Sync),
    settings: &Settings,
) -> Result<Image, Error> {
    let image = render(camera, radiance, settings, &())?;
    trace_chosen(&image, |pixel| {
        trace_samples(settings, pixel, |x, y| {
            let ray = camera.ray_for(settings.size, x, y);
            push_ray(&ray);
            radiance(&ray)
        })
    });
    Ok(image)
}
