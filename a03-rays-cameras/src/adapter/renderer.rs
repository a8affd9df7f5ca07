//! The choice of the renderer for a view.

use common::{Error, Image, Progress, Renderer, Settings};
use engine::adaptive::KnownLight;

use super::instruments::{self, Instruments};
use super::registry;
use crate::{Camera, Ray, View, render};

impl View {
    /// Renders the picture with the renderer of the settings.
    pub fn render(self, settings: &Settings, progress: &dyn Progress) -> Result<Image, Error> {
        let instruments = Instruments::of_settings(settings);
        if settings.renderer == Renderer::Engine
            && let Some(scene) = self.world.for_engine(settings.depth)
        {
            return registry::render(scene, &*self.camera, settings, progress);
        }
        let bounds = settings.max_error.map(|max_error| {
            let scene = self.world.for_engine(settings.depth);
            let of_scene = |scene: engine::Scene| {
                let camera = registry::camera_for_engine(&*self.camera);
                scene.known_light(&camera, settings.size)
            };
            let known = scene.map_or_else(|| KnownLight::up_to(f64::INFINITY), of_scene);
            (max_error, known)
        });
        let Self { camera, world } = match instruments {
            Some(instruments) => self.instrumented(instruments),
            None => self,
        };
        let radiance = |ray: &Ray| world.radiance(ray, settings.depth);
        let Some((max_error, known)) = bounds else {
            return render(&camera, radiance, settings, progress);
        };
        let light = |x, y| radiance(&camera.ray_for(settings.size, x, y));
        engine::adaptive::render_image(max_error, &known, &light, settings, progress)
    }

    /// The view with these instruments.
    pub(crate) fn instrumented(self, instruments: Instruments) -> Self {
        Self {
            camera: instruments::instrumented::camera(self.camera),
            world: self.world.instrumented(instruments),
        }
    }
}
