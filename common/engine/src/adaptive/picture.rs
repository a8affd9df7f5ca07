//! `Picture`: the samples of all pixels, and how more are taken.

use std::mem;
use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering};

use common::{Error, Progress, Settings, Size};
use rayon::iter::{IndexedParallelIterator, ParallelExtend, ParallelIterator};
use rayon::slice::{ParallelSlice, ParallelSliceMut};

use super::Radiance;
use super::pixel::Pixel;
use super::random::PixelRandom;
use super::sequence::Sequence;
use crate::camera_place;

/// Pairs of samples per batch, unless a pixel's last ones end it.
const BATCH: usize = 32;

/// The pixels of the rows to be rendered, and where their light comes from.
pub struct Picture<'a, R> {
    radiance: &'a R,
    settings: &'a Settings,
    progress: &'a dyn Progress,
    pixels: Vec<Pixel>,
    /// The number of rows painted so far.
    painted: AtomicU32,
}

impl<'a, R: Radiance> Picture<'a, R> {
    /// The rows that the settings select, without samples.
    pub fn new(
        radiance: &'a R,
        settings: &'a Settings,
        progress: &'a dyn Progress,
    ) -> Result<Self, Error> {
        let size = Size::new(settings.size.width(), settings.rows().len() as u32)?;
        let mut pixels = Vec::new();
        pixels
            .try_reserve_exact(size.pixels())
            .map_err(|_| Error::Memory { size })?;
        pixels.par_extend(rayon::iter::repeat_n(Pixel::NONE, size.pixels()));
        Ok(Self {
            radiance,
            settings,
            progress,
            pixels,
            painted: AtomicU32::new(0),
        })
    }

    /// All pixels, row after row.
    pub fn pixels(&self) -> &[Pixel] {
        &self.pixels
    }

    /// The number of pixels in a row.
    pub fn width(&self) -> usize {
        self.settings.size.width() as usize
    }

    /// The number that selects the samples of the picture.
    pub fn seed(&self) -> u64 {
        self.settings.seed
    }

    /// Takes as many pairs of samples as are wanted of each pixel altogether: a function of
    /// its index.
    pub fn take(&mut self, wanted: impl Fn(usize) -> u32 + Sync) {
        self.change_rows(|picture, row, pixels| {
            let first = row * pixels.len();
            let more = pixels.iter().zip(first..);
            let more = more.map(|(pixel, i)| pixel.pairs()..wanted(i));
            let fresh = picture.sample(row, picture.seed(), (0..).zip(more));
            for (pixel, fresh) in pixels.iter_mut().zip(&fresh) {
                if fresh.pairs() > 0 {
                    pixel.merge(fresh);
                }
            }
        });
    }

    /// The results of a function of each row and its pixels.
    pub fn each_row<T: Send>(&self, f: impl Fn(usize, &[Pixel]) -> T + Sync) -> Vec<T> {
        let rows = self.pixels.par_chunks_exact(self.width()).enumerate();
        let rows = rows.with_max_len(1);
        rows.map(|(row, pixels)| f(row, pixels)).collect()
    }

    /// Like `each_row`, with a function that changes the pixels.
    pub fn change_rows<T: Send>(
        &mut self,
        f: impl Fn(&Self, usize, &mut [Pixel]) -> T + Sync,
    ) -> Vec<T> {
        let mut pixels = mem::take(&mut self.pixels);
        let rows = pixels.par_chunks_exact_mut(self.width()).enumerate();
        let changed = rows.with_max_len(1).map(|(row, pixels)| {
            let result = f(self, row, pixels);
            self.paint(row, pixels);
            result
        });
        let results = changed.collect();
        self.pixels = pixels;
        results
    }

    /// New samples of the pixels of a row: of some columns, the pairs with these numbers in
    /// the pixel's sequence.
    pub fn sample(
        &self,
        row: usize,
        seed: u64,
        wanted: impl Iterator<Item = (u32, Range<u32>)>,
    ) -> Vec<Pixel> {
        let row = self.settings.rows().start + row as u32;
        let mut pixels = vec![Pixel::NONE; self.width()];
        let (mut columns, mut places, mut light) = (Vec::new(), Vec::new(), Vec::new());
        let mut look = |columns: &mut Vec<u32>, places: &mut Vec<_>| {
            if !self.progress.stopped() {
                self.radiance.light(places, &mut light);
                for (column, pair) in columns.iter().zip(light.chunks_exact(2)) {
                    pixels[*column as usize].add([pair[0], pair[1]]);
                }
            }
            columns.clear();
            places.clear();
        };
        for (column, numbers) in wanted.filter(|(_, numbers)| !numbers.is_empty()) {
            let sequence = Sequence::new(PixelRandom::new(seed, column, row));
            for i in numbers {
                let place = |place| camera_place(self.settings.size, (column, row), place);
                places.extend(sequence.pair(i).map(place));
                columns.push(column);
                if columns.len() == BATCH {
                    look(&mut columns, &mut places);
                }
            }
        }
        look(&mut columns, &mut places);
        pixels
    }

    /// Shows a row as it is now.
    fn paint(&self, row: usize, pixels: &[Pixel]) {
        let rows = self.settings.rows();
        if self.painted.fetch_add(1, Ordering::Relaxed) >= rows.len() as u32 {
            self.progress.more_rows(1);
        }
        let mut colors = pixels.iter().map(Pixel::mean);
        self.progress.row(rows.start + row as u32, &mut colors);
    }

    /// An error once the picture is not wanted any more.
    pub fn check_stopped(&self) -> Result<(), Error> {
        if self.progress.stopped() {
            Err(Error::Stopped)
        } else {
            Ok(())
        }
    }
}
