//! `TracedScene`: a scene with a name, whose picture is traced.

use std::sync::Arc;

use common::sensitivity::{Footprint, NumberPlace};
use common::{
    ArgumentError, Color, Edits, Error, Image, Picture, PixelTrace, Progress, Scene, SeenLine,
    Settings, Size, Traced, UsedSettings,
};

use super::kinds::NumberedFile;
use crate::View;

/// Camera and world for a picture with these settings.
pub type ViewOfSettings = dyn Fn(&Settings) -> Result<View, Error> + Send + Sync;

/// A scene whose picture is traced: its names, and its camera and world as a value.
#[derive(Clone)]
pub struct TracedScene {
    /// The name on the command line, in kebab case.
    pub name: &'static str,
    /// A description of the picture, in one line.
    pub about: &'static str,
    /// Camera and world for a picture with these settings.
    pub view: Arc<ViewOfSettings>,
    /// Whether surfaces reflect rays, so that the depth changes the picture.
    pub reflects: bool,
    /// The settings where the command line has no others.
    pub defaults: Settings,
    /// The scene file that it was read from.
    pub file: Option<Arc<NumberedFile>>,
}

impl TracedScene {
    /// A scene without mirrors, with the usual settings.
    pub fn new(
        name: &'static str,
        about: &'static str,
        view: fn(Size) -> Result<View, ArgumentError>,
    ) -> Self {
        Self {
            name,
            about,
            view: Arc::new(move |settings| Ok(view(settings.size)?)),
            reflects: false,
            defaults: Settings::default(),
            file: None,
        }
    }

    /// The same scene, with surfaces that reflect rays.
    #[must_use]
    pub fn reflecting(self) -> Self {
        Self {
            reflects: true,
            ..self
        }
    }

    /// Camera and world, with the camera where a person has moved it in the window.
    fn edited_view(&self, settings: &Settings) -> Result<View, Error> {
        let view = (self.view)(settings)?;
        if settings.edits == Edits::default() {
            return Ok(view);
        }
        Ok(view.edited(settings.size, &settings.edits))
    }
}

impl Traced for TracedScene {
    fn render(&self, settings: &Settings, progress: &dyn Progress) -> Result<Image, Error> {
        self.edited_view(settings)?.render(settings, progress)
    }

    fn color(&self, settings: &Settings, pixel: [u32; 2]) -> Result<Color, Error> {
        Ok(self.edited_view(settings)?.color(settings, pixel))
    }

    fn trace(&self, settings: &Settings, pixel: [u32; 2]) -> Result<PixelTrace, Error> {
        Ok(self.edited_view(settings)?.trace(settings, pixel))
    }

    fn why_black(&self, settings: &Settings) -> Result<Option<String>, Error> {
        Ok(self.edited_view(settings)?.why_black(settings))
    }

    fn drawing(&self, settings: &Settings, trace: &PixelTrace) -> Result<String, Error> {
        let view = self.edited_view(settings)?;
        Ok(view.drawing(&trace.steps, self.name))
    }

    fn seen_rays(&self, settings: &Settings, trace: &PixelTrace) -> Result<Vec<SeenLine>, Error> {
        let view = self.edited_view(settings)?;
        Ok(view.seen_rays(settings.size, &trace.steps))
    }

    fn camera_lines(&self, settings: &Settings) -> Result<String, Error> {
        self.edited_view(settings)?.camera_lines(settings)
    }

    fn export(&self, language: &str, settings: &Settings) -> Result<String, Error> {
        self.edited_view(settings)?.export(language, settings)
    }

    fn numbers(&self, settings: &Settings) -> Result<Vec<NumberPlace>, Error> {
        let Some(file) = &self.file else {
            return Err(Error::Usage(format!(
                "{} is a scene of the program, whose numbers stand in its code; name a scene file, \
                 such as one that `export {} --to toml -o scene.toml` writes",
                self.name, self.name
            )));
        };
        Ok(file.numbers(settings))
    }

    fn with(
        &self,
        settings: &Settings,
        number: &NumberPlace,
        value: f64,
    ) -> Option<Box<dyn Traced>> {
        let known = Arc::clone(self.file.as_ref()?);
        let file = known.file.with(settings.transfer, number, value)?;
        Some(Box::new(Self {
            view: Arc::new(move |_| known.view_of(&file)),
            ..self.clone()
        }))
    }

    fn footprint(&self, settings: &Settings, pixel: Option<[u32; 2]>) -> Result<Footprint, Error> {
        Ok(self.edited_view(settings)?.footprint(settings.size, pixel))
    }
}

/// The scene for the program of the stage.
impl From<TracedScene> for Scene {
    fn from(scene: TracedScene) -> Self {
        Self {
            name: scene.name,
            about: scene.about,
            defaults: scene.defaults.clone(),
            uses: UsedSettings {
                size: true,
                sampling: true,
                depth: scene.reflects,
                file: false,
            },
            is_large: false,
            files: Vec::new(),
            notes: Vec::new(),
            picture: Picture::Traced(Arc::new(scene)),
        }
    }
}
