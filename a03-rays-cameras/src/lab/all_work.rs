//! A rendering that leaves nothing out, for the comparison with the lesson.

use std::hint::black_box;

use common::tally::{self, Work};
use common::{Color, Error, Image, Progress, Settings};

use crate::fast::render_by_lesson;
use crate::{Camera, PixelRandom, Ray};

/// Like [`render`](crate::render), but draws two random numbers for each sample
/// with a fixed place, too. The picture is the same.
pub fn render(
    camera: &(impl Camera + ?Sized),
    radiance: impl Fn(&Ray) -> Color + Sync,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let random = PixelRandom::new(settings.seed, 0, 0);
    let is_fixed = !settings.sampling.is_random();
    let radiance = |ray: &Ray| {
        if is_fixed {
            tally::count_all(Work::RandomNumber, 2);
            for n in 0..2 {
                // Unused numbers, which the compiler would remove.
                black_box(random.uniform(black_box(n)));
            }
        }
        radiance(ray)
    };
    render_by_lesson(camera, radiance, settings, progress)
}
