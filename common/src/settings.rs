//! `Settings`: the parameters of a rendering, which a reader can change without
//! changing the scene.

use std::path::PathBuf;

use crate::{Omissions, Size, Transfer};

/// Where the samples of a pixel lie.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sampling {
    /// One sample in the middle.
    #[default]
    Center,
    /// A square grid, each sample in the middle of its cell.
    Regular,
    /// Anywhere in the pixel.
    Random,
    /// A square grid, each sample anywhere in its cell.
    Stratified,
}

impl Sampling {
    /// All kinds of places.
    pub const ALL: [Self; 4] = [Self::Center, Self::Regular, Self::Random, Self::Stratified];

    /// Whether samples lie on a square grid, so that their number is a square.
    #[must_use]
    pub const fn is_grid(self) -> bool {
        matches!(self, Self::Regular | Self::Stratified)
    }

    /// Whether random numbers decide where the samples lie.
    #[must_use]
    pub const fn is_random(self) -> bool {
        matches!(self, Self::Random | Self::Stratified)
    }
}

/// The code that renders a picture. The bytes of the picture are the same for all
/// three.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Renderer {
    /// Exactly the code that the stages teach.
    #[default]
    Lesson,
    /// The fast renderer.
    Engine,
    /// The lesson without its omissions.
    NoOmissions,
}

impl Renderer {
    /// All renderers, the lesson first.
    pub const ALL: [Self; 3] = [Self::Lesson, Self::Engine, Self::NoOmissions];
}

/// The way of the camera that a person moves in the window; none by default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Edits {
    /// The angles by which the camera is rotated around the middle of the scene, in radians:
    /// around the vertical axis, and upwards.
    pub orbit: [f64; 2],
    /// Steps towards the middle of the scene. Each takes a tenth of the distance.
    pub steps: i32,
}

/// The parameters of a rendering.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Width and height of the picture.
    pub size: Size,
    /// Samples per pixel; with a `max_error`, the most samples of a pixel, but at
    /// least four.
    pub samples: u32,
    /// The places of the samples in a pixel.
    pub sampling: Sampling,
    /// The largest root mean square error of the picture, above 0, for channels from
    /// 0 to 1, with 95 % confidence. With it, adaptive sampling chooses the places of
    /// the samples, and `sampling` is ignored.
    pub max_error: Option<f64>,
    /// Selects the random numbers; the same seed gives the same picture.
    pub seed: u64,
    /// The number of surfaces that a ray may hit, up to [`Settings::MAX_DEPTH`]: 1 shows no
    /// reflection.
    pub depth: u32,
    /// The code that renders the picture.
    pub renderer: Renderer,
    /// The work that the renderer leaves out, to measure it; none for the renderer as it is.
    pub omissions: Option<Omissions>,
    /// The curve by which the picture will be shown or saved. Of the scene it changes only the
    /// colours that are given as bytes of this picture, such as `"#ff8000"` in a scene file.
    pub transfer: Transfer,
    /// The picture file to open, for a scene that opens one.
    pub file: Option<PathBuf>,
    /// The way of the camera, in a scene that has one.
    pub edits: Edits,
}

impl Settings {
    /// Most surfaces that a ray may hit. Between perfect mirrors a ray hits as many as it may,
    /// so that a picture of a larger depth would not end. Of 10000 mirrors that reflect 0.999 of
    /// the light, 1/22000 is left, which no picture shows.
    pub const MAX_DEPTH: u32 = 10_000;
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            size: Size::COURSE,
            samples: 1,
            sampling: Sampling::Center,
            max_error: None,
            seed: 0,
            depth: 6,
            renderer: Renderer::Lesson,
            omissions: None,
            transfer: Transfer::Linear,
            file: None,
            edits: Edits::default(),
        }
    }
}
