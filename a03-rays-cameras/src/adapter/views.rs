//! `Views`: where the camera and the world of a traced scene come from.

use std::any::Any;

use common::{
    ArgumentError, Color, Edits, Error, Image, PixelTrace, Progress, Scene, SceneNumber, Settings,
    Size, Traced,
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

    fn color(&self, settings: &Settings, pixel: [u32; 2]) -> Result<Color, Error> {
        Ok(self.view(settings)?.color(settings, pixel))
    }

    fn trace(&self, settings: &Settings, pixel: [u32; 2]) -> Result<PixelTrace, Error> {
        Ok(self.view(settings)?.trace(settings, pixel))
    }

    fn numbers(&self, settings: &Settings) -> Option<Vec<SceneNumber>> {
        match self {
            Self::Code(_) => None,
            Self::File(file) => Some(file.numbers(settings)),
        }
    }

    fn with(
        &self,
        settings: &Settings,
        number: &SceneNumber,
        value: f64,
    ) -> Option<Box<dyn Traced>> {
        match self {
            Self::Code(_) => None,
            Self::File(file) => {
                let moved = file.with(settings, number, value)?;
                Some(Box::new(Self::File(Box::new(moved))))
            }
        }
    }

    fn pixel_step(
        &self,
        settings: &Settings,
        number: &SceneNumber,
        pixel: Option<[u32; 2]>,
    ) -> Result<f64, Error> {
        let footprint = self.view(settings)?.footprint(settings.size, pixel);
        let step = footprint.step(number);
        let Self::File(file) = self else {
            return Ok(step);
        };
        if number.table != "[camera]" {
            return Ok(step);
        }
        let little = step / 1024.0;
        let moved = file.with(settings, number, number.value + little);
        Ok(match moved.and_then(|moved| moved.view(settings).ok()) {
            Some(view) => step.min(little * footprint.camera_steps(settings.size, &view)),
            None => step,
        })
    }
}
