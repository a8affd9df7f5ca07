//! `Scene`: a picture of a stage, and the code that renders it.

use std::path::PathBuf;
use std::sync::Arc;

use crate::{Color, Error, Image, PixelTrace, Progress, Settings, Size};

type Paint = dyn Fn(&Settings, &dyn Progress) -> Result<Image, Error> + Send + Sync;

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

/// A piece of a ray in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeenLine {
    /// Both ends, in pixels from the upper left corner.
    pub ends: [[f64; 2]; 2],
    /// Whether an object lies before it.
    pub is_hidden: bool,
}

/// A scene whose rays can be followed one by one.
pub trait Explained: Send + Sync {
    /// The numbers behind a pixel, whose column and row lie in the picture, by the renderer of
    /// the settings. The engine has only those of the samples.
    fn trace(&self, settings: &Settings, pixel: [u32; 2]) -> Result<PixelTrace, Error>;

    /// The rays of the first sample from the side and from above, as SVG.
    fn drawing(&self, settings: &Settings, trace: &PixelTrace) -> Result<String, Error>;

    /// The rays of the first sample after the camera's, as the camera sees them.
    fn seen_rays(&self, settings: &Settings, trace: &PixelTrace) -> Result<Vec<SeenLine>, Error>;

    /// The places of the lights that have one.
    fn light_places(&self, settings: &Settings) -> Result<Vec<[f64; 3]>, Error>;

    /// The scene as text in a language: `toml` or `povray`.
    fn export(&self, language: &str, settings: &Settings) -> Result<String, Error>;
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
    /// The way to the numbers behind its pixels and to its text, for a scene of rays.
    pub explained: Option<Arc<dyn Explained>>,
    paint: Arc<Paint>,
}

impl Scene {
    /// A scene that is painted at any size, without rays.
    pub fn painted(
        name: &'static str,
        about: &'static str,
        paint: impl Fn(&Settings, &dyn Progress) -> Result<Image, Error> + Send + Sync + 'static,
    ) -> Self {
        let uses = UsedSettings {
            size: true,
            ..UsedSettings::default()
        };
        Self {
            name,
            about,
            defaults: Settings::default(),
            uses,
            is_large: false,
            files: Vec::new(),
            explained: None,
            paint: Arc::new(paint),
        }
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

    /// A scene whose pixels are sampled by rays.
    pub fn traced(
        name: &'static str,
        about: &'static str,
        trace: impl Fn(&Settings, &dyn Progress) -> Result<Image, Error> + Send + Sync + 'static,
    ) -> Self {
        let mut scene = Self::painted(name, about, trace);
        scene.uses.sampling = true;
        scene
    }

    /// Pictures side by side, for comparison: each has an equal share of the width, with
    /// a gap of 8 pixels between them, and by default this width and height.
    pub fn side_by_side<P, const N: usize>(
        name: &'static str,
        about: &'static str,
        panels: [P; N],
        (width, height): (u32, u32),
    ) -> Self
    where
        P: Fn(&Settings, &dyn Progress) -> Result<Image, Error> + Send + Sync + 'static,
    {
        const GAP: u32 = 8;
        let count = N.max(1) as u32;
        let gaps = GAP * (count - 1);
        let defaults = Settings {
            size: Size::new(count * width + gaps, height).unwrap_or(Size::COURSE),
            ..Settings::default()
        };
        let paint = move |settings: &Settings, progress: &dyn Progress| {
            let size = settings.size;
            let width = size.width().saturating_sub(gaps) / count;
            let panel = Settings {
                size: Size::new(width, size.height())?,
                ..settings.clone()
            };
            let mut image = Image::black(size)?.map(|_| Color::WHITE);
            for (left, paint) in (0..).step_by((width + GAP) as usize).zip(&panels) {
                if progress.stopped() {
                    return Err(Error::Stopped);
                }
                image.paste(left, 0, &paint(&panel, &())?);
            }
            for (y, row) in (0..).zip(image.rows()) {
                progress.row(y, &mut row.iter().copied());
            }
            Ok(image)
        };
        Self::traced(name, about, paint).with_defaults(defaults)
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

    /// The way to the numbers behind its pixels and to its text; an error if it has no rays.
    pub fn rays(&self) -> Result<&dyn Explained, Error> {
        let lacks = || Error::Usage(format!("{} is painted, without rays to follow", self.name));
        self.explained.as_deref().ok_or_else(lacks)
    }

    /// Renders the picture.
    pub fn render(&self, settings: &Settings, progress: &dyn Progress) -> Result<Image, Error> {
        (self.paint)(settings, progress)
    }
}
