//! `render`: the one loop over the pixels of a traced picture.

use common::{Color, Error, Image, Progress, Settings, Size};
use measure::tally::{self, Work};
use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use crate::{Camera, Radiance, Ray, Sampler, adaptive};

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
    let one_by_one = |rays: &[Ray], light: &mut [Color]| {
        for (ray, light) in rays.iter().zip(light) {
            *light = radiance(ray);
        }
    };
    render_together(camera, one_by_one, settings, progress)
}

/// So many rays are asked for together, or about so many.
pub(crate) const TOGETHER: usize = 64;

/// The same, for who can follow several rays at once.
pub fn render_together(
    camera: &(impl Camera + ?Sized),
    radiance: impl Radiance,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let rows = settings.rows().len() as u32;
    let mut image = Image::black(Size::new(settings.size.width(), rows)?)?;
    let copy = |colors: &[Color], pixels: &mut [Color]| pixels.copy_from_slice(colors);
    render_rows(
        camera,
        radiance,
        settings,
        progress,
        image.pixels_mut(),
        copy,
    )?;
    Ok(image)
}

/// The same, for who keeps something else of a picture than its colours, bytes for
/// example: `keep` is told the colours of a row once they are final, and where in
/// `kept` its share is. All rows have equal shares.
///
/// [`Error::Stopped`] if `progress` stops the rendering, and [`Error::Memory`] if what
/// the settings bound the error of does not fit into memory.
///
/// # Panics
///
/// If `kept` has fewer elements than the picture has rows.
pub fn render_rows<T: Send>(
    camera: &(impl Camera + ?Sized),
    radiance: impl Radiance,
    settings: &Settings,
    progress: &dyn Progress,
    kept: &mut [T],
    keep: impl Fn(&[Color], &mut [T]) + Sync,
) -> Result<(), Error> {
    let view = View {
        camera,
        radiance,
        settings,
        progress,
    };
    if let Some(max_error) = settings.max_error {
        return adaptive::render(max_error, settings, &view, progress, kept, keep);
    }
    let sampler = Sampler::new(settings);
    let samples = sampler.samples();
    let together = TOGETHER.div_ceil(samples as usize);
    let place = |column, row, sample| view.place(column, row, sampler.place(sample, column, row));
    let paint = |row, pixels: &mut [Color]| {
        let (mut places, mut rays, mut light) = (Vec::new(), Vec::new(), Vec::new());
        // ANCHOR: mean
        let mut first = 0;
        for pixels in pixels.chunks_mut(together) {
            let columns = first..first + pixels.len() as u32;
            first = columns.end;
            for start in (0..samples).step_by(TOGETHER) {
                if progress.stopped() {
                    return false;
                }
                places.clear();
                if samples == 1 {
                    places.extend(columns.clone().map(|column| place(column, row, 0)));
                    view.look(&places, &mut rays, pixels);
                    continue;
                }
                let some = start..samples.min(start + TOGETHER as u32);
                let of_pixel = |column| some.clone().map(move |i| place(column, row, i));
                places.extend(columns.clone().flat_map(of_pixel));
                light.resize(places.len(), Color::BLACK);
                view.look(&places, &mut rays, &mut light);
                for (pixel, light) in pixels.iter_mut().zip(light.chunks(some.len())) {
                    *pixel = light.iter().fold(*pixel, |sum, light| sum + *light);
                }
            }
            if samples > 1 {
                for pixel in pixels {
                    *pixel = pixel.map(|channel| channel / f64::from(samples));
                }
            }
        }
        // ANCHOR_END: mean
        true
    };
    let (rows, width) = (settings.rows(), settings.size.width() as usize);
    let shares = kept.par_chunks_mut(kept.len() / rows.len());
    // One by one: one may take far longer than another, and none shall wait for long.
    (rows.into_par_iter().zip(shares).with_max_len(1)).for_each(|(row, kept)| {
        let mut pixels = vec![Color::BLACK; width];
        if paint(row, &mut pixels) {
            keep(&pixels, kept);
            progress.row(row, &mut pixels.into_iter());
        }
    });
    if progress.stopped() {
        return Err(Error::Stopped);
    }
    Ok(())
}

/// What a camera sees.
struct View<'a, C: ?Sized, R> {
    camera: &'a C,
    radiance: R,
    settings: &'a Settings,
    progress: &'a dyn Progress,
}

impl<C: Camera + ?Sized, R: Radiance> View<'_, C, R> {
    // ANCHOR: place
    /// Where the camera finds a place in the pixel in this column and row.
    fn place(&self, column: u32, row: u32, (dx, dy): (f64, f64)) -> (f64, f64) {
        // The camera counts rows from below, and from pixel middles.
        let x = f64::from(column) + (dx - 0.5);
        let y = f64::from(self.settings.size.height() - 1 - row) - (dy - 0.5);
        (x, y)
    }
    // ANCHOR_END: place

    /// The light that comes from some places; the rays there are left over.
    fn look(&self, places: &[(f64, f64)], rays: &mut Vec<Ray>, light: &mut [Color]) {
        rays.clear();
        self.camera.rays_for(self.settings.size, places, rays);
        tally::count_all(Work::PrimaryRay, rays.len() as u64);
        self.radiance.along(rays, light);
    }
}

impl<C: Camera + ?Sized, R: Radiance> adaptive::View for View<'_, C, R> {
    fn light(&self, places: &[adaptive::Place], light: &mut Vec<Color>) {
        let in_pixels = |place: &_| self.place(0, 0, adaptive::beside(*place, self.settings.seed));
        let places = places.iter().map(in_pixels);
        light.resize(places.len(), Color::BLACK);
        self.look(&places.collect::<Vec<_>>(), &mut Vec::new(), light);
    }

    fn may_hide(&self, (x, y): (u32, u32), side: u32, narrow: f64) -> bool {
        let [left, right, top, bottom] = [x, x + side, y, y + side].map(f64::from);
        let corners = [(left, top), (right, top), (left, bottom), (right, bottom)];
        let places = corners.map(|place| self.place(0, 0, place));
        let mut rays = Vec::with_capacity(places.len());
        self.camera.rays_for(self.settings.size, &places, &mut rays);
        let rays = rays.as_slice().try_into();
        rays.is_ok_and(|rays| self.radiance.may_hide(rays, narrow / f64::from(side)))
    }

    fn stopped(&self) -> bool {
        self.progress.stopped()
    }
}
