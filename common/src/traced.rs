//! `Traced`: what programs ask of a scene of a camera and a world. It is a trait because this crate knows
//! neither: stage 3 implements it for the scenes of all stages.

use std::any::Any;

use crate::{Error, Image, PixelTrace, Progress, Settings};

/// A scene of a camera and a world.
pub trait Traced: Any + Send + Sync {
    /// The picture, by the renderer of the settings.
    fn render(&self, settings: &Settings, progress: &dyn Progress) -> Result<Image, Error>;

    /// The numbers behind a pixel, whose column and row lie in the picture, by the renderer of
    /// the settings. The engine has only those of the samples.
    fn trace(&self, settings: &Settings, pixel: [u32; 2]) -> Result<PixelTrace, Error>;

    /// The rays of the first sample from the side and from above, as SVG, whose title has the name of
    /// the scene.
    fn drawing(
        &self,
        settings: &Settings,
        trace: &PixelTrace,
        scene: &str,
    ) -> Result<String, Error>;

    /// The rays of the first sample after the camera's, as the camera sees them.
    fn seen_rays(&self, settings: &Settings, trace: &PixelTrace) -> Result<Vec<SeenLine>, Error>;

    /// Why the picture is black all over; none if no reason is sure.
    fn why_black(&self, settings: &Settings) -> Result<Option<String>, Error>;

    /// The camera as the lines of a scene file.
    fn camera_lines(&self, settings: &Settings) -> Result<String, Error>;

    /// The scene as text in a language: `toml` or `povray`.
    fn export(&self, language: &str, settings: &Settings) -> Result<String, Error>;
}

/// A piece of a ray in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeenLine {
    /// Both ends, in pixels from the upper left corner.
    pub ends: [[f64; 2]; 2],
    /// Whether an object lies before it.
    pub is_hidden: bool,
}
