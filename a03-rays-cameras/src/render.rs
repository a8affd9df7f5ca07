//! `render`: the loop over the pixels of a traced picture.

use common::{Color, Error, Image, Progress, Settings, Size};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use crate::{Camera, Ray, Sampler};

/// Renders a picture. A pixel is the mean of `radiance`, the light that comes back
/// along a ray, over the rays of `camera` through it.
///
/// The threads of the current rayon pool share the rows. Pixels are independent,
/// so the number of threads does not change the picture.
///
/// [`Error::Stopped`] if `progress` stops the rendering, [`Error::Memory`] if
/// the picture does not fit into memory.
pub fn render(
    camera: &(impl Camera + ?Sized),
    radiance: impl Fn(&Ray) -> Color + Sync,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let (size, sampler) = (settings.size, Sampler::new(settings));
    let mut image = Image::black(size)?;
    let rows = image.pixels_mut().par_chunks_mut(size.width() as usize);
    // One row at a time for a thread, because some rows take far longer than others.
    let rows = rows.zip(0..size.height()).with_max_len(1);
    rows.for_each(|(pixels, row)| {
        // ANCHOR: mean
        for (column, pixel) in (0..).zip(&mut *pixels) {
            if progress.stopped() {
                return;
            }
            for place in sampler.places(column, row) {
                let (x, y) = camera_coordinates(size, column, row, place);
                *pixel += radiance(&camera.ray_for(size, x, y));
            }
            *pixel = *pixel / f64::from(sampler.samples());
        }
        progress.row(row, &mut pixels.iter().copied());
        // ANCHOR_END: mean
    });
    if progress.stopped() {
        return Err(Error::Stopped);
    }
    Ok(image)
}

// ANCHOR: place
/// Camera coordinates of the position (`dx`, `dy`) in a pixel of a picture of this
/// size.
#[must_use]
pub fn camera_coordinates(size: Size, column: u32, row: u32, (dx, dy): (f64, f64)) -> (f64, f64) {
    // Camera coordinates count upwards, from the middles of pixels.
    let x = f64::from(column) + (dx - 0.5);
    let y = f64::from(size.height() - 1 - row) - (dy - 0.5);
    (x, y)
}
// ANCHOR_END: place
