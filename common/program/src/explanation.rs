//! `Explanation`: the numbers behind a pixel, for the window.

use common::{Error, PixelTrace, Renderer, Sampling, SeenLine, Settings, Traced};

/// The numbers behind a pixel, and its rays in the picture.
pub struct Explanation {
    /// The numbers.
    pub trace: PixelTrace,
    /// The rays after the camera's.
    pub rays: Vec<SeenLine>,
}

/// Most samples of an explained pixel: of more, it is explained by one in its middle.
const MOST_SAMPLES: u32 = 16;

impl Explanation {
    /// Follows the rays of a pixel by the lesson.
    pub(crate) fn new(
        traced: &dyn Traced,
        mut settings: Settings,
        pixel: [u32; 2],
    ) -> Result<Self, Error> {
        if settings.max_error.take().is_some() || settings.samples > MOST_SAMPLES {
            (settings.samples, settings.sampling) = (1, Sampling::Center);
        }
        settings.renderer = Renderer::Lesson;
        let trace = traced.trace(&settings, pixel)?;
        let rays = traced.seen_rays(&settings, &trace)?;
        Ok(Self { trace, rays })
    }
}
