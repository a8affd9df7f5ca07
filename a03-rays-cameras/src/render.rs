//! `render`: the one loop over the pixels of a traced picture.

use common::tally::{self, Work};
use common::{Color, Error, Image, Progress, Settings, Size};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use crate::{Camera, Ray, Sampler, adaptive};

/// Renders a picture, or the rows of it that are wanted: each pixel is the mean
/// of `radiance`, the light that comes back along a ray, over the rays that
/// `camera` sends through it.
///
/// Rows are shared out to the threads of the current rayon pool. A pixel does
/// not depend on any other, so their number does not change the picture. Where
/// the settings bound the error, samples are taken in passes over the picture,
/// and what one pass finds decides on the next.
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
    let rows = settings.rows();
    let mut image = Image::black(Size::new(size.width(), rows.len() as u32)?)?;
    // ANCHOR: light
    let light = |column: u32, row: u32, (dx, dy): (f64, f64)| {
        // The camera counts rows from below, and from pixel middles.
        let x = f64::from(column) + (dx - 0.5);
        let y = f64::from(size.height() - 1 - row) - (dy - 0.5);
        tally::count(Work::PrimaryRay);
        radiance(&camera.ray_for(size, x, y))
    };
    // ANCHOR_END: light
    if let Some(max_error) = settings.max_error {
        adaptive::render(&mut image, max_error, settings, light, progress)?;
        return Ok(image);
    }
    // ANCHOR: mean
    let sampler = Sampler::new(settings);
    let mean = |column, row, pixel: &mut Color, (): &mut ()| {
        let (mut sum, mut samples) = (Color::BLACK, 0.0);
        for place in sampler.places(column, row) {
            sum += light(column, row, place);
            samples += 1.0;
        }
        *pixel = sum.map(|channel| channel / samples);
        true
    };
    // ANCHOR_END: mean
    let mut nothing = vec![(); image.size().pixels()];
    for_each_pixel(&mut image, rows.start, &mut nothing, progress, mean)?;
    Ok(image)
}

/// Paints the pixels of some column and row. Each has a `note` beside it; `paint`
/// says whether it changes the pixel, and rows that change are reported.
pub(crate) fn for_each_pixel<N: Send>(
    image: &mut Image,
    first_row: u32,
    notes: &mut [N],
    progress: &dyn Progress,
    paint: impl Fn(u32, u32, &mut Color, &mut N) -> bool + Sync,
) -> Result<(), Error> {
    let width = image.size().width() as usize;
    let paint_row = |(row, (pixels, notes)): (usize, (&mut [Color], &mut [N]))| {
        let row = first_row + row as u32;
        let mut changed = false;
        for (column, (pixel, note)) in (0..).zip(pixels.iter_mut().zip(notes)) {
            if progress.stopped() {
                return;
            }
            changed |= paint(column, row, pixel, note);
        }
        if changed {
            progress.row(row, pixels);
        }
    };
    let notes = notes.par_chunks_exact_mut(width);
    image
        .pixels_mut()
        .par_chunks_exact_mut(width)
        .zip(notes)
        .enumerate()
        .for_each(paint_row);

    if progress.stopped() {
        return Err(Error::Stopped);
    }
    Ok(())
}
