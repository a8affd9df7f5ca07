//! The numbers behind a pixel of a view.

use a02_math::arrays::array;
use std::sync::Arc;

use common::steps::{self, REFLECTED, Step};
use common::traced_picture::trace_chosen;
use common::{Color, Error, Explained, Image, PixelTrace, Renderer, SeenLine, Settings, Size};

use super::watched::push_ray;
use super::{drawing, seen_rays};
use crate::{Camera, Ray, Sampler, View, camera_coordinates, fast, render};

const SAMPLES: &str = "a03-rays-cameras.md#many-rays-a-pixel";
const LOOP: &str = "a03-rays-cameras.md#the-only-loop";
const MIRRORS: &str = "a06-shadows-reflection.md#how-deep";

impl View {
    /// The steps from a pixel, whose column and row lie in the picture, to its colour, by the
    /// renderer of the settings. The engine takes only the steps of the loop over the samples.
    #[must_use]
    pub fn trace(self, settings: &Settings, pixel: [u32; 2]) -> PixelTrace {
        if settings.renderer == Renderer::Engine
            && let Some(scene) = self.world.for_engine(settings.depth)
        {
            let camera = fast::camera(&*self.camera);
            let renderer = engine::Renderer::new(scene, camera, settings);
            return trace_samples(settings, pixel, |x, y| renderer.light_at(settings, (x, y)));
        }
        let view = self.watched(settings, settings.renderer == Renderer::AllWork);
        trace_samples(settings, pixel, |x, y| {
            let ray = view.camera.ray_for(settings.size, x, y);
            view.world.radiance(&ray, settings.depth)
        })
    }

    /// The rays of the first sample of these steps from the side and from above, as SVG, whose
    /// title has a name of the scene.
    #[must_use]
    pub fn drawing(self, steps: &[Step], name: &str) -> String {
        drawing::svg(&*self.world.watched(false), steps, name)
    }
}

/// The steps from a pixel to the mean of the light at the places of its samples.
fn trace_samples(
    settings: &Settings,
    pixel: [u32; 2],
    light: impl Fn(f64, f64) -> Color,
) -> PixelTrace {
    let ([column, row], size, sampler) = (pixel, settings.size, Sampler::new(settings));
    let (color, steps) = steps::recorded(|| {
        let mut sum = Color::BLACK;
        for (i, place) in (1..).zip(sampler.places(column, row)) {
            let (x, y) = camera_coordinates(size, column, row, place);
            let sample = || {
                let name = format!("sample {i} of {}", sampler.samples());
                let step = Step::new("sample", name, SAMPLES).with("place", [place.0, place.1]);
                step.with("x", [x]).with("y", [y])
            };
            sum += steps::inside(sample, || {
                let light = light(x, y);
                let is_mirror = |step: &Step| step.kind == REFLECTED;
                let mirrors = steps::so_far(|steps| steps.iter().any(is_mirror));
                let section = if mirrors == Some(true) { MIRRORS } else { LOOP };
                let step = Step::new("radiance", "light along the ray", section);
                steps::heading(|| step.with("f", light.channels()));
                light
            });
        }
        let mean = sum.map(|sum| sum / f64::from(sampler.samples()));
        let step = Step::new("mean", "mean of the samples", LOOP);
        steps::push(|| step.with("c", mean.channels()));
        mean
    });
    PixelTrace {
        pixel,
        color,
        steps,
    }
}

/// Renders a picture, as [`render`], and traces its chosen pixel: for code that is not in the
/// lesson, as that of exercises.
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

/// The name of a scene, and the function that makes its view for each picture.
pub struct ViewOf<F>(pub &'static str, pub Arc<F>);

impl<F: Fn(Size) -> Result<View, Error>> ViewOf<F> {
    fn view(&self, settings: &Settings) -> Result<View, Error> {
        self.1(settings.size)?.moved(settings, &*self.1)
    }
}

impl<F: Fn(Size) -> Result<View, Error> + Send + Sync> Explained for ViewOf<F> {
    fn trace(&self, settings: &Settings, pixel: [u32; 2]) -> Result<PixelTrace, Error> {
        Ok(self.view(settings)?.trace(settings, pixel))
    }

    fn drawing(&self, settings: &Settings, trace: &PixelTrace) -> Result<String, Error> {
        Ok(self.view(settings)?.drawing(&trace.steps, self.0))
    }

    fn seen_rays(&self, settings: &Settings, trace: &PixelTrace) -> Result<Vec<SeenLine>, Error> {
        let view = self.view(settings)?.watched(settings, false);
        Ok(seen_rays::seen_rays(&view, settings.size, &trace.steps))
    }

    fn light_places(&self, settings: &Settings) -> Result<Vec<[f64; 3]>, Error> {
        let mut view = self.view(settings)?;
        let places = view.world.light_places().into_iter();
        Ok(places.map(|place| array(*place)).collect())
    }

    fn export(&self, language: &str, settings: &Settings) -> Result<String, Error> {
        self.view(settings)?.export(language, settings)
    }
}
