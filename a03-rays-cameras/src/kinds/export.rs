//! Writes a view in another language, from the numbers of its rows.

use common::{Error, Settings};
use scene_file::{POV_RAY, TOML, export};

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
                    &camera,
                    settings,
                )
            }
            None => Err("its world is a formula, without shapes".to_owned()),
        };
        text.map_err(|reason| Error::Usage(format!("this scene cannot be written: {reason}")))
    }
}
