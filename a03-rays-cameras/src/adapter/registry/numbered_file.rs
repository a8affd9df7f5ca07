//! `NumberedFile`: the scene file that a scene was read from, whose numbers have their places.

use std::sync::Arc;

use common::{Error, SceneNumber, Settings};
use scene_file::SceneFile;

use crate::View;
use crate::registry::Format;

/// The scene file that a scene was read from.
pub struct NumberedFile {
    /// How its stage reads it.
    pub format: Format,
    /// Its text.
    pub text: Arc<str>,
    /// What was read.
    pub file: SceneFile,
}

impl NumberedFile {
    /// All numbers of the file in the order of its text. Colours in bytes are those of pictures with
    /// the transfer of the settings.
    #[must_use]
    pub fn numbers(&self, settings: &Settings) -> Vec<SceneNumber> {
        let file = self.file.with_transfer(settings.transfer);
        file.numbers(&self.text)
    }

    /// The same file with another value of a number; none if it is not allowed.
    #[must_use]
    pub fn with(&self, settings: &Settings, number: &SceneNumber, value: f64) -> Option<Self> {
        Some(Self {
            file: self.file.with(settings.transfer, number, value)?,
            text: Arc::clone(&self.text),
            format: self.format,
        })
    }

    /// By how much a number is moved so that the things in a pixel move by about its width; without
    /// a pixel, those of the picture. A colour or a factor moves by a fraction of itself.
    pub fn pixel_step(
        &self,
        settings: &Settings,
        number: &SceneNumber,
        pixel: Option<[u32; 2]>,
    ) -> Result<f64, Error> {
        let footprint = self.view(settings)?.footprint(settings.size, pixel);
        let step = footprint.step(number);
        if number.table != "[camera]" {
            return Ok(step);
        }
        let little = step / 1024.0;
        let moved = self.with(settings, number, number.value + little);
        Ok(match moved.and_then(|moved| moved.view(settings).ok()) {
            Some(view) => step.min(little * footprint.camera_steps(settings.size, &view)),
            None => step,
        })
    }

    /// The camera and the world of the file.
    pub fn view(&self, settings: &Settings) -> Result<View, Error> {
        let view = (self.format.view)(&self.file.with_transfer(settings.transfer));
        view.map_err(|error| Error::SceneFile(error.within(&self.text)))
    }
}
