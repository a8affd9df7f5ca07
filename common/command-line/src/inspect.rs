//! `Inspect`: what the commands ask of a traced scene besides its picture. Only stage 3, which knows
//! cameras and worlds, can answer, and the programs of the stages pass its [`Inspector`].

use common::{Error, PixelTrace, Scene, Settings};

/// A piece of a ray in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeenLine {
    /// Both ends, in pixels from the upper left corner.
    pub ends: [[f64; 2]; 2],
    /// Whether an object lies before it.
    pub is_hidden: bool,
}

/// A traced scene with its camera and its world.
pub trait Inspect {
    /// Why the picture is black all over; none if no reason is sure.
    fn why_black(&self, settings: &Settings) -> Result<Option<String>, Error>;

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

    /// The camera as the lines of a scene file.
    fn camera_lines(&self, settings: &Settings) -> Result<String, Error>;

    /// The scene as text in a language: `toml` or `povray`.
    fn export(&self, language: &str, settings: &Settings) -> Result<String, Error>;
}

/// Looks into a scene; an error if it is painted, without rays to follow.
pub type Inspector = fn(&Scene) -> Result<&dyn Inspect, Error>;

/// The inspector of a stage without rays.
pub fn no_rays(scene: &Scene) -> Result<&dyn Inspect, Error> {
    Err(scene.no_rays())
}
