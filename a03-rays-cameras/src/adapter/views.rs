//! `Views`: where the camera and the world of a traced scene come from.

use std::any::Any;

use common::{
    ArgumentError, Edits, Error, Image, PixelTrace, Progress, Scene, SeenLine, Settings, Size,
    Traced,
};

use super::registry::NumberedFile;
use crate::View;

/// Where the camera and the world of a traced scene come from.
pub enum Views {
    /// A function of a stage's `scenes.rs`, for a picture of this size.
    Code(fn(Size) -> Result<View, ArgumentError>),
    /// A scene file.
    File(Box<NumberedFile>),
}

/// A scene of a stage, without mirrors and with the usual settings.
pub fn traced_scene(
    name: &'static str,
    about: &'static str,
    view: fn(Size) -> Result<View, ArgumentError>,
) -> Scene {
    Scene::traced(name, about, Views::Code(view))
}

impl Views {
    /// Those of a scene; an error if it is painted.
    pub fn of(scene: &Scene) -> Result<&Self, Error> {
        let rays: &dyn Any = scene.rays()?;
        rays.downcast_ref().ok_or_else(|| scene.no_rays())
    }

    /// Camera and world for a picture with these settings, with the camera where a person has moved
    /// it in the window.
    pub fn view(&self, settings: &Settings) -> Result<View, Error> {
        let view = match self {
            Self::Code(view) => view(settings.size)?,
            Self::File(file) => file.view(settings)?,
        };
        if settings.edits == Edits::default() {
            return Ok(view);
        }
        Ok(view.edited(settings.size, &settings.edits))
    }
}

impl Traced for Views {
    fn render(&self, settings: &Settings, progress: &dyn Progress) -> Result<Image, Error> {
        self.view(settings)?.render(settings, progress)
    }

    fn trace(&self, settings: &Settings, pixel: [u32; 2]) -> Result<PixelTrace, Error> {
        Ok(self.view(settings)?.trace(settings, pixel))
    }

    fn drawing(
        &self,
        settings: &Settings,
        trace: &PixelTrace,
        scene: &str,
    ) -> Result<String, Error> {
        Ok(self.view(settings)?.drawing(&trace.steps, scene).svg)
    }

    fn seen_rays(&self, settings: &Settings, trace: &PixelTrace) -> Result<Vec<SeenLine>, Error> {
        let view = self.view(settings)?;
        Ok(view.seen_rays(settings.size, &trace.steps))
    }

    fn why_black(&self, settings: &Settings) -> Result<Option<String>, Error> {
        let of_stage = matches!(self, Self::Code(_));
        Ok(self.view(settings)?.why_black(settings, of_stage))
    }

    fn camera_lines(&self, settings: &Settings) -> Result<String, Error> {
        self.view(settings)?.camera_lines(settings)
    }

    fn export(&self, language: &str, settings: &Settings) -> Result<String, Error> {
        self.view(settings)?.export(language, settings)
    }
}
