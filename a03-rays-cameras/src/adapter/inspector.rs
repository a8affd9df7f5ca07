//! `inspector`: answers the commands of the program that ask for more than a picture.

use command_line::{Inspect, SeenLine};
use common::{Error, PixelTrace, Scene, Settings};

use super::views::Views;

/// Looks into a scene of rays.
pub fn inspector(scene: &Scene) -> Result<&dyn Inspect, Error> {
    Ok(Views::of(scene)?)
}

impl Inspect for Views {
    fn why_black(&self, settings: &Settings) -> Result<Option<String>, Error> {
        let of_stage = matches!(self, Self::Code(_));
        Ok(self.view(settings)?.why_black(settings, of_stage))
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

    fn camera_lines(&self, settings: &Settings) -> Result<String, Error> {
        self.view(settings)?.camera_lines(settings)
    }

    fn export(&self, language: &str, settings: &Settings) -> Result<String, Error> {
        self.view(settings)?.export(language, settings)
    }
}
