//! Adaptive sampling: few samples where light changes evenly, and many at edges and
//! highlights, until the picture is as exact as it was asked to be.
//!
//! The picture is parted into cells, squares whose light is told by that at their
//! corners: first into blocks of 4 x 4 pixels. Those cells that err most are divided
//! into four, and their parts again, as far as it takes. Neighbours share corners, so
//! that a pixel takes about one sample for its four; and where an edge crosses it, only
//! sides are looked at whose ends differ.
//!
//! (To look at the corners and to divide where they differ is Whitted's way, An
//! Improved Illumination Model for Shaded Display, 1980; to begin with blocks larger
//! than a pixel is that of Akimoto, Mase and Suenaga, Pixel-Selected Ray Tracing,
//! 1991.)
//!
//! An object that lies between the corners of all pixels is missed, and so is the tip of
//! a needle.

mod block;
mod cell;
mod crosses;
#[cfg(test)]
mod drawn;
mod edge;
mod experience;
mod lattice;
mod level;
mod place;
pub(crate) mod random;
mod strip;

use std::iter;

use common::{Color, Error, Image, Progress, Sampled, Settings, Size};
use rayon::iter::{
    IndexedParallelIterator, IntoParallelRefIterator, IntoParallelRefMutIterator, ParallelIterator,
};
use rayon::slice::ParallelSliceMut;

use crate::{camera_place, image_of_rows};
use cell::{DEEPEST, PIXEL_DEPTH};
use lattice::Lattice;
use level::Level;
use place::{Place, beside};
use strip::{Strip, TILE};

/// Light at places of a picture, in the coordinates of the camera: whole numbers are the
/// middles of pixels, and y counts upwards.
pub trait Radiance: Sync {
    /// The light at some places.
    fn light(&self, places: &[(f64, f64)], light: &mut Vec<Color>);

    /// Whether an object narrower than this share of the side could lie between the
    /// corners of a square.
    fn may_miss_features(&self, _corners: &[(f64, f64); 4], _feature_size: f64) -> bool {
        true
    }
}

/// Light of one place after the other, from a function.
struct OneByOne<F>(F);

impl<F: Fn(f64, f64) -> Color + Sync> Radiance for OneByOne<F> {
    fn light(&self, places: &[(f64, f64)], light: &mut Vec<Color>) {
        light.clear();
        light.extend(places.iter().map(|(x, y)| (self.0)(*x, *y)));
    }
}

/// Renders the picture, or the rows of it that the settings select, of the light at each
/// place, until its estimated root mean square error is at most `max_error`.
pub fn render_image(
    max_error: f64,
    light: impl Fn(f64, f64) -> Color + Sync,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let light = OneByOne(light);
    image_of_rows(settings, |pixels, copy| {
        render(max_error, settings, &light, progress, pixels, copy)
    })
}

/// The light at corners of cells.
trait View: Sync {
    /// The light at some places.
    fn light(&self, places: &[Place], light: &mut Vec<Color>);
    /// Whether an object so narrow, in pixels, could lie in a square whose upper left
    /// pixel is in this column and row.
    fn may_hide(&self, square: (u32, u32), side: u32, narrow: f64) -> bool;
    /// True once the picture is not wanted any more.
    fn stopped(&self) -> bool;
}

/// The corners of a picture's cells, each jittered by up to a quarter of the smallest.
struct Jittered<'a, R> {
    radiance: &'a R,
    settings: &'a Settings,
    progress: &'a dyn Progress,
}

impl<R> Jittered<'_, R> {
    fn camera_place(&self, place: (f64, f64)) -> (f64, f64) {
        camera_place(self.settings.size, (0, 0), place)
    }
}

impl<R: Radiance> View for Jittered<'_, R> {
    fn light(&self, places: &[Place], light: &mut Vec<Color>) {
        let jittered = |place: &Place| self.camera_place(beside(*place, self.settings.seed));
        let places: Vec<_> = places.iter().map(jittered).collect();
        self.radiance.light(&places, light);
    }

    fn may_hide(&self, (x, y): (u32, u32), side: u32, narrow: f64) -> bool {
        let [left, right, top, bottom] = [x, x + side, y, y + side].map(f64::from);
        let corners = [(left, top), (right, top), (left, bottom), (right, bottom)];
        let corners = corners.map(|corner| self.camera_place(corner));
        let feature_size = narrow / f64::from(side);
        self.radiance.may_miss_features(&corners, feature_size)
    }

    fn stopped(&self) -> bool {
        self.progress.stopped()
    }
}

/// Safety factor: aim at this share of the allowed squared error, because the estimate is
/// itself uncertain.
const AIM: f64 = 0.6;

/// Like [`render_image`], but hands each finished row to `keep`, with its share of
/// `kept`, instead of building an image. Each part of a picture comes to the bound alone,
/// and so the whole does.
pub fn render<T: Send>(
    max_error: f64,
    settings: &Settings,
    radiance: &impl Radiance,
    progress: &dyn Progress,
    kept: &mut [T],
    keep: impl Fn(&[Color], &mut [T]) + Sync,
) -> Result<(), Error> {
    let view = &Jittered {
        radiance,
        settings,
        progress,
    };
    let wanted = settings.rows();
    let size = Size::new(settings.size.width(), wanted.len() as u32)?;
    let fair = AIM * 3.0 * max_error * max_error;
    // Summed over pixels and channels.
    let allowed = fair * size.pixels() as f64;
    let mut level = Level::unknown(settings.samples, fair);

    let lattice = Lattice::new(size, wanted.start, view)?;
    let tops = wanted.clone().step_by(TILE as usize);
    let mut strips: Vec<_> = tops
        .map(|top| Strip::new(&lattice, size.width(), top..wanted.end.min(top + TILE)))
        .collect();
    for_each(&mut strips, progress, |strip| {
        strip.begin(&level, view);
        true
    })?;

    // Parts are divided, too, once it is known what to expect of that.
    let mut times = 1;
    let error = loop {
        level.learn(strips.iter().map(Strip::experience));
        let error: f64 = strips.iter().map(|strip| strip.error(&level)).sum();
        if error <= allowed {
            break error;
        }
        let cells = strips.iter().flat_map(Strip::cells);
        level.come_down(cells, error, allowed);
        let due = strips.iter().filter(|strip| strip.is_due(&level));
        let rows = due.map(|strip| strip.rows().len() as u32).sum();
        if rows == 0 {
            break error;
        }
        progress.more_rows(rows);
        for_each(&mut strips, progress, |strip| {
            strip.divide(times, &level, view)
        })?;
        times = DEEPEST;
    };

    let per_row = kept.len() / wanted.len();
    let of_strips = kept.par_chunks_mut(per_row * TILE as usize);
    (strips.par_iter().zip(of_strips).with_max_len(1)).for_each(|(strip, kept)| {
        let mut pixels = vec![Color::BLACK; size.width() as usize];
        for (row, kept) in strip.rows().zip(kept.chunks_exact_mut(per_row)) {
            strip.paint(row, &mut pixels);
            keep(&pixels, kept);
        }
    });

    let samples: u64 = strips.iter().map(Strip::samples).sum();
    let depth = strips.iter().map(Strip::depth).max().unwrap_or(PIXEL_DEPTH);
    progress.sampled(&Sampled {
        pixels: size.pixels() as u64,
        samples: samples + lattice.samples(),
        most: 1 << (2 * (depth - PIXEL_DEPTH)),
        squared_error: error / 3.0,
    });
    Ok(())
}

/// Works on all strips; `change` says whether one looks differently then.
fn for_each(
    strips: &mut [Strip],
    progress: &dyn Progress,
    change: impl Fn(&mut Strip) -> bool + Sync,
) -> Result<(), Error> {
    strips.par_iter_mut().with_max_len(1).for_each(|strip| {
        if progress.stopped() || !change(strip) {
            return;
        }
        for row in strip.rows() {
            let painted = || {
                let mut pixels = vec![Color::BLACK; strip.width()];
                strip.paint(row, &mut pixels);
                pixels
            };
            progress.row(row, &mut iter::once_with(painted).flatten());
        }
    });
    if progress.stopped() {
        return Err(Error::Stopped);
    }
    Ok(())
}
