//! `PixelPanel`: the numbers behind a pixel, for the window.

use std::sync::atomic::{AtomicBool, Ordering};

use common::sensitivity::Influence;
use common::{Color, Error, PixelTrace, Progress, Renderer, Sampling, SeenLine, Settings, Traced};

/// The numbers behind a pixel, and its rays in the picture.
pub struct PixelPanel {
    /// The numbers.
    pub trace: PixelTrace,
    /// The rays after the camera's.
    pub rays: Vec<SeenLine>,
    /// Which samples of the pixel are followed.
    pub samples: String,
}

/// Most samples of an explained pixel: of more, it is explained by one in its middle.
const MOST_SAMPLES: u32 = 16;

impl PixelPanel {
    /// Follows the rays of a pixel by the lesson.
    pub(crate) fn new(
        traced: &dyn Traced,
        mut settings: Settings,
        pixel: [u32; 2],
    ) -> Result<Self, Error> {
        let samples = which_samples(&settings);
        take_few_samples(&mut settings);
        let trace = traced.trace(&settings, pixel)?;
        let rays = traced.seen_rays(&settings, &trace)?;
        Ok(Self {
            trace,
            rays,
            samples,
        })
    }
}

/// Takes one sample in the middle of a pixel instead of many, by the lesson.
const fn take_few_samples(settings: &mut Settings) {
    if settings.max_error.take().is_some() || settings.samples > MOST_SAMPLES {
        (settings.samples, settings.sampling) = (1, Sampling::Center);
    }
    settings.renderer = Renderer::Lesson;
}

/// How a pixel changes with the numbers of its scene file, the strongest first. One thread looks for
/// them, and leaves the others to the window.
pub fn strongest(
    traced: &dyn Traced,
    mut settings: Settings,
    pixel: [u32; 2],
    progress: &dyn Progress,
) -> Result<Vec<Influence>, Error> {
    take_few_samples(&mut settings);
    let thread = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    // The window answers keys while this thread works.
    #[cfg(target_os = "linux")]
    thread.broadcast(|_| rustix::process::nice(10));
    thread.install(|| traced.influences(&settings, pixel, progress))
}

/// Stops a computation from another thread.
#[derive(Debug, Default)]
pub struct StopFlag(AtomicBool);

impl StopFlag {
    /// Stops it.
    pub fn set(&self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

impl Progress for StopFlag {
    fn row(&self, _: u32, _: &mut dyn Iterator<Item = Color>) {}

    fn stopped(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// Says which samples of a pixel are followed with these settings.
fn which_samples(settings: &Settings) -> String {
    match (settings.max_error, settings.samples) {
        (Some(_), _) => "One sample in the middle of the pixel. The picture takes as many samples \
                         as its error bound needs."
            .to_owned(),
        (None, 1) => "The one sample of the pixel.".to_owned(),
        (None, samples @ 2..=MOST_SAMPLES) => format!("All {samples} samples of the pixel."),
        (None, samples) => {
            format!("One sample in the middle of the pixel, which stands for its {samples}.")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_panel_says_which_samples_it_follows() {
        let said = |samples, max_error| {
            which_samples(&Settings {
                samples,
                max_error,
                ..Settings::default()
            })
        };
        assert_eq!(said(1, None), "The one sample of the pixel.");
        assert_eq!(said(16, None), "All 16 samples of the pixel.");
        assert!(said(64, None).ends_with("stands for its 64."));
        assert!(said(1024, Some(0.1)).contains("error bound"));
    }
}
