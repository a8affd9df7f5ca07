//! Writes a view in another language, from the numbers of its rows.

use common::{Error, Settings};

use scene_export::{POV_RAY, TOML, export, write_camera};

use super::camera_for_engine;
use crate::View;

impl View {
    /// The scene as text in a language, `toml` or `povray`.
    pub fn export(&self, language: &str, settings: &Settings) -> Result<String, Error> {
        let phrases = if language == "povray" { POV_RAY } else { TOML };
        let text = match self.world.for_engine(settings.depth) {
            Some(scene) => {
                let camera = camera_for_engine(&*self.camera);
                export(
                    phrases,
                    &scene,
                    &self.world.written_shapes(),
                    &self.world.written_materials(),
                    &self.world.written_lights(),
                    &camera,
                    settings,
                )
            }
            None => Err("its world is a formula, without shapes".to_owned()),
        };
        text.map_err(|reason| Error::Usage(format!("this scene cannot be written: {reason}")))
    }

    /// The table `[camera]` of a scene file.
    pub fn camera_lines(&self, settings: &Settings) -> Result<String, Error> {
        let camera = camera_for_engine(&*self.camera);
        let text = write_camera(TOML, &camera, settings)
            .map_err(|reason| Error::Usage(format!("this camera cannot be written: {reason}")))?;
        // The table of the world follows.
        let end = text.find("\n[world]").unwrap_or(text.len());
        Ok(text[..end].trim().to_owned())
    }
}
