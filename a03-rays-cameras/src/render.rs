//! `render`: the one loop over the pixels of a traced picture.

use common::tally::{self, Work};
use common::{Color, Error, Image, Progress, Settings};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use crate::{Camera, Ray, Sampler};

/// Renders a picture: each pixel is the mean of `radiance`, the light that
/// comes back along a ray, over the rays that `camera` sends through it.
///
/// Rows are shared out to the threads of the current rayon pool. A pixel does
/// not depend on any other, so their number does not change the picture.
///
/// [`Error::Stopped`] if `progress` stops the rendering, [`Error::Memory`] if
/// the picture does not fit into memory.
pub fn render(
    camera: &(impl Camera + ?Sized),
    radiance: impl Fn(&Ray) -> Color + Sync,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let size = settings.size;
    let sampler = Sampler::new(settings);
    let mut image = Image::black(size)?;

    let paint_row = |(row, pixels): (usize, &mut [Color])| {
        let row = row as u32;
        for (column, pixel) in (0..).zip(&mut *pixels) {
            if progress.stopped() {
                return;
            }
            let (mut sum, mut samples) = (Color::BLACK, 0.0);
            for (dx, dy) in sampler.places(column, row) {
                // The camera counts rows from below, and from pixel middles.
                let x = f64::from(column) + (dx - 0.5);
                let y = f64::from(size.height() - 1 - row) - (dy - 0.5);
                tally::count(Work::PrimaryRay);
                sum += radiance(&camera.ray_for(size, x, y));
                samples += 1.0;
            }
            *pixel = sum.map(|channel| channel / samples);
        }
        progress.row(row, pixels);
    };
    image
        .pixels_mut()
        .par_chunks_exact_mut(size.width() as usize)
        .enumerate()
        .for_each(paint_row);

    if progress.stopped() {
        return Err(Error::Stopped);
    }
    Ok(image)
}
