//! Instruments: wrappers that count work and record steps, drawings of rays, and orbiting cameras,
//! for the program and the window. No lesson uses them.

#![expect(clippy::must_use_candidate, reason = "called by the program and tests")]

use common::{Omissions, Renderer, Settings, steps};

mod black_picture;
mod drawing;
mod footprint;
pub mod instrumented;
pub mod orbit_camera;
pub mod pixel_trace;
mod seen_rays;

/// The task of the wrappers around the parts of a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instruments {
    /// They report all steps of a renderer that leaves out this work.
    Report(Omissions),
    /// They report nothing, and leave out only this work, for a measurement of time.
    Silent(Omissions),
}

impl Instruments {
    /// For the steps of the lesson.
    pub const LESSON: Self = Self::Report(Omissions::ALL);

    /// For a picture with these settings; none for the renderer as it is.
    pub(crate) fn of_settings(settings: &Settings) -> Option<Self> {
        let omissions = match settings.renderer {
            Renderer::NoOmissions => Some(Omissions::NONE),
            _ => settings.omissions,
        };
        if steps::is_counting() {
            Some(Self::Report(omissions.unwrap_or(Omissions::ALL)))
        } else {
            omissions.map(Self::Silent)
        }
    }

    /// The work that is left out.
    pub const fn omissions(self) -> Omissions {
        match self {
            Self::Report(omissions) | Self::Silent(omissions) => omissions,
        }
    }
}
