//! `TracedScene`: a row of the table of scenes in a stage's `stage.rs`.

use common::{ArgumentError, Progress, Scene, Settings, Size};

use crate::View;

/// A scene whose picture is traced: its names, and its camera and world as a value.
#[derive(Clone, Debug)]
pub struct TracedScene {
    /// The name on the command line, in kebab case.
    pub name: &'static str,
    /// A description of the picture, in one line.
    pub about: &'static str,
    /// Camera and world for a picture of this size.
    pub view: fn(Size) -> Result<View, ArgumentError>,
    /// Whether surfaces reflect rays, so that the depth changes the picture.
    pub reflects: bool,
    /// The settings where the command line has no others.
    pub defaults: Settings,
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
            view,
            reflects: false,
            defaults: Settings::default(),
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
}

/// The scene for the program of the stage.
impl From<TracedScene> for Scene {
    fn from(row: TracedScene) -> Self {
        let view = row.view;
        let paint = move |settings: &Settings, progress: &dyn Progress| {
            view(settings.size)?.render(settings, progress)
        };
        let mut scene = Self::traced(row.name, row.about, paint).with_defaults(row.defaults);
        scene.uses.depth = row.reflects;
        scene
    }
}
