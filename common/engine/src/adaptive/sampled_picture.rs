//! `SampledPicture`: the samples of all pixels, and how more are taken.

use std::mem;
use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering};

use common::{Error, Progress, Settings};
use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use super::known_light::KnownLight;
use super::pixel::Pixel;
use super::random::PixelRandom;
use super::sequence::Sequence;
use super::{LightAt, Radiance};
use crate::sampler::image_position;

/// Pairs of samples in a batch.
const BATCH_PAIRS: usize = 32;

/// The pixels of a picture, and where their light comes from.
pub struct SampledPicture<'a> {
    radiance: &'a dyn Radiance,
    settings: &'a Settings,
    pub progress: &'a dyn Progress,
    pixels: Vec<Pixel>,
    /// The bits of the brightest channel of a sample. Bits of numbers above 0 grow with them.
    brightest: AtomicU32,
}

impl<'a> SampledPicture<'a> {
    /// A picture without samples.
    pub fn new(
        radiance: &'a dyn Radiance,
        settings: &'a Settings,
        progress: &'a dyn Progress,
    ) -> Result<Self, Error> {
        let size = settings.size;
        let mut pixels = Vec::new();
        pixels
            .try_reserve_exact(size.pixels())
            .map_err(|_| Error::Memory { size })?;
        rayon::iter::repeat_n(Pixel::NONE, size.pixels()).collect_into_vec(&mut pixels);
        Ok(Self {
            radiance,
            settings,
            progress,
            pixels,
            brightest: AtomicU32::new(1_f32.to_bits()),
        })
    }

    /// All pixels, row after row.
    pub fn pixels(&self) -> &[Pixel] {
        &self.pixels
    }

    /// The number of samples in pairs of all pixels.
    pub fn samples(&self) -> u64 {
        let pairs = self.pixels.par_iter().map(Pixel::pairs);
        pairs.map(|pairs| u64::from(2 * pairs)).sum()
    }

    /// The number of pixels in a row.
    pub fn width(&self) -> usize {
        self.settings.size.width() as usize
    }

    /// A random number that chooses a pixel. It is independent of the positions of its samples.
    pub fn choice(&self, column: u32, row: usize) -> f64 {
        PixelRandom::new(!self.settings.seed, column, row as u32).uniform(0)
    }

    /// The brightest channel of a sample, but at least 1.
    pub fn brightest(&self) -> f64 {
        f32::from_bits(self.brightest.load(Ordering::Relaxed)).into()
    }

    /// A function that gives the light at some positions; none once the rendering is stopped.
    fn tracer(&self) -> LightAt<'_> {
        let mut tracer = self.radiance.tracer();
        Box::new(move |positions, light| {
            light.clear();
            if self.progress.stopped() {
                return;
            }
            tracer(positions, light);
            let channels = light.iter().flat_map(|light| light.channels());
            let finite = channels.filter(|channel| channel.is_finite());
            let brightest = finite.fold(0.0, f64::max) as f32;
            self.brightest
                .fetch_max(brightest.to_bits(), Ordering::Relaxed);
        })
    }

    /// Takes the first pairs of samples of each pixel.
    pub fn take(&mut self, pairs: u32) {
        self.change_rows(&|picture, row, pixels| {
            let columns = 0..pixels.len() as u32;
            let searched = columns.filter(|column| !pixels[*column as usize].is_background());
            for (column, new) in picture.sample(row, searched.map(|column| (column, 0..pairs))) {
                pixels[column as usize] = new;
            }
        });
    }

    /// Takes a sample in the middle of each pixel, or only of those in which no object can be seen, and
    /// returns their number. Where such a sample shows the background, no other would differ.
    pub fn take_middles(&mut self, of_all: bool, known: &KnownLight) -> u64 {
        let counts = self.change_rows(&|picture, row, pixels| {
            let (size, first) = (picture.settings.size, row * pixels.len());
            let is_without = |column: u32| {
                let without = known.without_objects.get(first + column as usize);
                without.copied().unwrap_or_default()
            };
            let mut columns: Vec<_> = (0..size.width()).collect();
            columns.retain(|column| of_all || is_without(*column));
            let middle = |column: &u32| image_position(size, (*column, row as u32), (0.5, 0.5));
            let middles: Vec<_> = columns.iter().map(middle).collect();
            let mut light = Vec::new();
            picture.tracer()(&middles, &mut light);
            for (column, light) in columns.iter().zip(light) {
                let is_background = is_without(*column) && light == known.background;
                pixels[*column as usize] = if is_background {
                    Pixel::of_background(light)
                } else {
                    Pixel::of_middle(light)
                };
            }
            columns.len() as u64
        });
        counts.iter().sum()
    }

    /// Calls a function that changes the pixels of a row, for all rows, and returns its results.
    pub fn change_rows<T: Send>(
        &mut self,
        f: &(dyn Fn(&Self, usize, &mut [Pixel]) -> T + Sync),
    ) -> Vec<T> {
        let mut pixels = mem::take(&mut self.pixels);
        let rows = pixels.par_chunks_exact_mut(self.width()).enumerate();
        let changed = rows.with_max_len(1).map(|(row, pixels)| {
            let result = f(self, row, pixels);
            self.report(row, pixels);
            result
        });
        let mut results = Vec::new();
        changed.collect_into_vec(&mut results);
        self.pixels = pixels;
        results
    }

    /// New samples of the pixels of a row: of some columns, from left to right, the pairs
    /// with these indices in the pixel's sequence.
    pub fn sample(
        &self,
        row: usize,
        pairs: impl Iterator<Item = (u32, Range<u32>)>,
    ) -> Vec<(u32, Pixel)> {
        let row = row as u32;
        let (mut columns, mut positions) = (Vec::new(), Vec::new());
        let (mut tracer, mut light) = (self.tracer(), Vec::new());
        let mut pixels: Vec<(u32, Pixel)> = Vec::new();
        let mut take_batch = |columns: &mut Vec<u32>, positions: &mut Vec<_>| {
            tracer(positions, &mut light);
            for (column, pair) in columns.drain(..).zip(light.chunks_exact(2)) {
                let pair = Pixel::of_pair([pair[0], pair[1]]);
                match pixels.last_mut() {
                    Some((last, pixel)) if *last == column => pixel.merge(&pair),
                    _ => pixels.push((column, pair)),
                }
            }
            positions.clear();
        };
        for (column, indices) in pairs.filter(|(_, indices)| !indices.is_empty()) {
            let sequence = Sequence::new(PixelRandom::new(self.settings.seed, column, row));
            for i in indices {
                let pair = sequence.pair(i);
                positions
                    .extend(pair.map(|at| image_position(self.settings.size, (column, row), at)));
                columns.push(column);
                if columns.len() == BATCH_PAIRS {
                    take_batch(&mut columns, &mut positions);
                }
            }
        }
        take_batch(&mut columns, &mut positions);
        pixels
    }

    /// Reports a row as it is now.
    fn report(&self, row: usize, pixels: &[Pixel]) {
        let mut colors = pixels.iter().map(Pixel::mean);
        self.progress.row(row as u32, &mut colors);
    }

    /// An error once the rendering is stopped.
    pub fn check_stopped(&self) -> Result<(), Error> {
        if self.progress.stopped() {
            Err(Error::Stopped)
        } else {
            Ok(())
        }
    }
}
