//! `Renderer`: a scene and a camera, prepared for rendering.

use common::{Color, Error, Image, Omission, Omissions, Progress, Settings};

use crate::accel::Accelerator;
use crate::adaptive::{self, KnownLight, Radiance};
use crate::lanes::level::{Level, level};
use crate::shade::{RadianceBound, max_radiance};
use crate::trace::Tracer;
use crate::view::View;
use crate::{Camera, Sampler, Scene};

/// Threshold of the reflection cutoff, relative to the allowed error. The samples may have all of
/// that, because the sum of both squares is hardly larger.
const CUTOFF: f64 = 1.0 / 8.0;

/// A scene and a camera, prepared for rendering.
pub struct Renderer<'a> {
    camera: Camera<'a>,
    tracer: Tracer<'a>,
    level: Level,
}

impl<'a> Renderer<'a> {
    /// Prepares a scene. Where the settings allow an error, reflections are cut off.
    #[must_use]
    pub fn new(scene: Scene<'a>, camera: Camera<'a>, settings: &Settings) -> Self {
        let cutoff = settings.max_error.map(|max_error| RadianceBound {
            max_radiance: max_radiance(&scene),
            threshold: max_error * CUTOFF,
        });
        let Scene {
            background,
            ambient,
            depth,
            mut shapes,
            surfaces,
            lights,
        } = scene;
        let omissions = settings.omissions.unwrap_or(Omissions::ALL);
        if omissions.contains(Omission::IdentityTransforms) {
            shapes.omit_identities();
        }
        let accelerator = if omissions.contains(Omission::DistantObjects) {
            Accelerator::new(shapes)
        } else {
            Accelerator::without_tree(shapes)
        };
        let tracer = Tracer {
            background,
            ambient,
            depth,
            accelerator,
            surfaces,
            lights,
            cutoff,
            omissions,
        };
        Self {
            camera,
            tracer,
            level: level(),
        }
    }

    /// Renders a picture.
    ///
    /// [`Error::Stopped`] if `progress` stops the rendering, [`Error::Memory`] if the
    /// picture does not fit into memory.
    pub fn render(
        &self,
        sampler: &impl Sampler,
        settings: &Settings,
        progress: &dyn Progress,
    ) -> Result<Image, Error> {
        let view = self.view(settings, progress);
        match settings.max_error {
            Some(max_error) => {
                let bound = self.tracer.cutoff.as_ref();
                let max = bound.map_or(f64::INFINITY, |bound| bound.max_radiance.largest_channel());
                let shapes = &self.tracer.accelerator.shapes;
                let known = KnownLight::of(
                    max,
                    self.tracer.background,
                    shapes,
                    &self.camera,
                    settings.size,
                );
                adaptive::render_image(max_error, &known, &view, settings, progress)
            }
            None => view.render(sampler),
        }
    }

    /// The light at a place of the picture, in camera coordinates: of one ray, to compare it.
    #[must_use]
    pub fn light_at(&self, settings: &Settings, place: (f64, f64)) -> Color {
        let mut light = Vec::new();
        self.view(settings, &()).tracer()(&[place], &mut light);
        light[0]
    }

    fn view<'v>(&'v self, settings: &'v Settings, progress: &'v dyn Progress) -> View<'v, 'a> {
        View {
            camera: &self.camera,
            tracer: &self.tracer,
            settings,
            progress,
            level: self.level,
        }
    }
}
