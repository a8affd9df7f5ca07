//! The numbers behind a pixel of a view.

use std::sync::Arc;

use common::steps::{self, Step};
use common::traced_picture::trace_chosen;
use common::{
    Color, Error, Explained, Image, PixelTrace, Renderer, Sampling, SeenLine, Settings, Size,
};

use super::watched::push_ray;
use super::{drawing, seen_rays};
use crate::{Camera, Ray, Sampler, View, camera_coordinates, fast, render};

const SAMPLES: &str = "a03-rays-cameras.md#many-rays-a-pixel";
const LOOP: &str = "a03-rays-cameras.md#the-only-loop";

/// A camera with one ray.
struct OneRay(Ray);

impl Camera for OneRay {
    fn ray_for(&self, _: Size, _: f64, _: f64) -> Ray {
        self.0
    }
}

impl View {
    /// The steps from a pixel, whose column and row lie in the picture, to its colour, by the
    /// renderer of the settings. The engine takes only the steps of the loop over the samples.
    pub fn trace(self, settings: &Settings, pixel: [u32; 2]) -> Result<PixelTrace, Error> {
        let size = settings.size;
        let one_pixel = Settings {
            size: Size::new(1, 1)?,
            samples: 1,
            sampling: Sampling::Center,
            ..settings.clone()
        };
        let view = match settings.renderer {
            Renderer::Engine => self,
            renderer => self.watched(settings, renderer == Renderer::AllWork),
        };
        let radiance = |ray: &Ray| match view.world.for_engine(settings.depth) {
            Some(scene) if settings.renderer == Renderer::Engine => {
                let image = fast::render(scene, &OneRay(*ray), &one_pixel, &())?;
                Ok::<_, Error>(image.pixels()[0])
            }
            _ => Ok(view.world.radiance(ray, settings.depth)),
        };
        trace_samples(settings, pixel, |x, y| {
            radiance(&view.camera.ray_for(size, x, y))
        })
    }

    /// The rays of the first sample of these steps from the side and from above, as SVG, whose
    /// title has a name of the scene.
    #[must_use]
    pub fn drawing(self, steps: &[Step], name: &str) -> String {
        drawing::svg(&*self.world.watched(false), steps, name)
    }
}

/// The steps from a pixel to the mean of this function of the places of its samples.
fn trace_samples(
    settings: &Settings,
    pixel: [u32; 2],
    color: impl Fn(f64, f64) -> Result<Color, Error>,
) -> Result<PixelTrace, Error> {
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
                let color = color(x, y)?;
                let step = Step::new("radiance", "light along the ray", LOOP);
                steps::heading(|| step.with("f", color.channels()));
                Ok::<_, Error>(color)
            })?;
        }
        let mean = sum.map(|sum| sum / f64::from(sampler.samples()));
        let step = Step::new("mean", "mean of the samples", LOOP);
        steps::push(|| step.with("c", mean.channels()));
        Ok::<_, Error>(mean)
    });
    Ok(PixelTrace {
        pixel,
        color: color?,
        steps,
    })
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
        let color = |x, y| {
            let ray = camera.ray_for(settings.size, x, y);
            push_ray(&ray);
            Ok(radiance(&ray))
        };
        trace_samples(settings, pixel, color).ok()
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
        self.view(settings)?.trace(settings, pixel)
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
        Ok(places.map(|place| place.to_glam().to_array()).collect())
    }

    fn export(&self, language: &str, settings: &Settings) -> Result<String, Error> {
        self.view(settings)?.export(language, settings)
    }
}
