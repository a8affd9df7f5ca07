//! `Scene`: a picture of a stage, painted by a function or traced through a camera and a world.

use std::path::PathBuf;
use std::sync::Arc;

use crate::{Error, Image, Progress, Settings, Traced};

/// A function that paints a picture with these settings.
pub type Paint = dyn Fn(&Settings, &dyn Progress) -> Result<Image, Error> + Send + Sync;

/// The [`Settings`] that a scene uses. The others do not change its picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "four independent properties")]
pub struct UsedSettings {
    /// The size of the picture.
    pub size: bool,
    /// Number, place and seed of the samples.
    pub sampling: bool,
    /// The number of surfaces that a ray may hit.
    pub depth: bool,
    /// The file to open.
    pub file: bool,
}

/// How the picture of a scene is made.
#[derive(Clone)]
pub enum Picture {
    /// By a function, without rays that could be followed.
    Painted(Arc<Paint>),
    /// By rays through a camera and a world.
    Traced(Arc<dyn Traced>),
}

/// A picture of a stage, under the name that the course gives it. A copy shares the code.
#[derive(Clone)]
pub struct Scene {
    /// The name on the command line, in kebab case.
    pub name: &'static str,
    /// A description of the picture, in one line.
    pub about: &'static str,
    /// The settings of the rendering where the command line has no others.
    pub defaults: Settings,
    /// The settings that change its picture.
    pub uses: UsedSettings,
    /// Whether only the fast renderer has its picture soon.
    pub is_large: bool,
    /// The files that it is made of, the scene file first; none for a scene of the stage.
    pub files: Vec<PathBuf>,
    /// Remarks on its files: what is drawn in another way than they say, or may not be meant.
    pub notes: Vec<String>,
    /// How its picture is made.
    pub picture: Picture,
}

impl Scene {
    fn new(name: &'static str, about: &'static str, picture: Picture) -> Self {
        Self {
            name,
            about,
            defaults: Settings::default(),
            uses: UsedSettings {
                size: true,
                ..UsedSettings::default()
            },
            is_large: false,
            files: Vec::new(),
            notes: Vec::new(),
            picture,
        }
    }

    /// A scene that is painted at any size, without rays.
    pub fn painted(
        name: &'static str,
        about: &'static str,
        paint: impl Fn(&Settings, &dyn Progress) -> Result<Image, Error> + Send + Sync + 'static,
    ) -> Self {
        Self::new(name, about, Picture::Painted(Arc::new(paint)))
    }

    /// A scene of a camera and a world, without mirrors.
    pub fn traced(name: &'static str, about: &'static str, traced: impl Traced) -> Self {
        let mut scene = Self::new(name, about, Picture::Traced(Arc::new(traced)));
        scene.uses.sampling = true;
        scene
    }

    /// A scene that shows a picture file in the size of the file.
    pub fn opened(
        name: &'static str,
        about: &'static str,
        open: impl Fn(&Settings, &dyn Progress) -> Result<Image, Error> + Send + Sync + 'static,
    ) -> Self {
        let mut scene = Self::painted(name, about, open);
        scene.uses.size = false;
        scene.uses.file = true;
        scene
    }

    /// A scene that is painted by a function that samples its pixels.
    pub fn sampled(
        name: &'static str,
        about: &'static str,
        paint: impl Fn(&Settings, &dyn Progress) -> Result<Image, Error> + Send + Sync + 'static,
    ) -> Self {
        let mut scene = Self::painted(name, about, paint);
        scene.uses.sampling = true;
        scene
    }

    /// The same scene, with surfaces that reflect rays.
    #[must_use]
    pub fn reflecting(mut self) -> Self {
        self.uses.depth = true;
        self
    }

    /// The same scene with other defaults.
    #[must_use]
    pub fn with_defaults(mut self, defaults: Settings) -> Self {
        self.defaults = defaults;
        self
    }

    /// Its camera and world, whose rays can be followed; an error if it is painted.
    pub fn rays(&self) -> Result<&dyn Traced, Error> {
        match &self.picture {
            Picture::Traced(traced) => Ok(&**traced),
            Picture::Painted(_) => Err(self.no_rays()),
        }
    }

    /// The error for a painted scene, whose rays are asked for.
    #[must_use]
    pub fn no_rays(&self) -> Error {
        Error::Usage(format!("{} is painted, without rays to follow", self.name))
    }

    /// Renders the picture.
    pub fn render(&self, settings: &Settings, progress: &dyn Progress) -> Result<Image, Error> {
        match &self.picture {
            Picture::Painted(paint) => paint(settings, progress),
            Picture::Traced(traced) => traced.render(settings, progress),
        }
    }
}
