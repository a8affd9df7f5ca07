//! `View`: a picture being rendered, in tile rows of two pixels.
//!
//! Four rays through a square of pixels stay closer together than four of a row, so that they
//! more often meet the same shapes.

use common::steps::{self, StepKind};
use common::{Color, Error, Image, Progress, Settings};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use crate::adaptive::{LightAt, Radiance};
use crate::lanes::Simd;
use crate::lanes::level::Level;
use crate::sampler::image_position;
use crate::trace::{BATCH, Batch, Tracer};
use crate::{Camera, Sampler};

/// Height of a tile row in pixels.
const TILE: usize = 2;

/// A picture being rendered.
pub(crate) struct View<'v, 'a> {
    pub camera: &'v Camera<'a>,
    pub tracer: &'v Tracer<'a>,
    pub settings: &'v Settings,
    pub progress: &'v dyn Progress,
    /// The instructions that are used.
    pub level: Level,
}

impl View<'_, '_> {
    /// The picture, with the sampler's number of samples in each pixel.
    pub fn render(&self, sampler: &impl Sampler) -> Result<Image, Error> {
        let size = self.settings.size;
        let width = size.width() as usize;
        let mut image = Image::black(size)?;
        // The last tile row may be lower.
        let orders: [_; TILE] = std::array::from_fn(|i| squares(size.width(), i as u32 + 1));
        let tile_rows = image.pixels_mut().par_chunks_mut(TILE * width).enumerate();
        // Each tile row is a task, because one may take far longer than another.
        tile_rows.with_max_len(1).for_each(|(tile_row, pixels)| {
            let first = (TILE * tile_row) as u32;
            let order = &orders[pixels.len() / width - 1];
            if self.render_tile_row(sampler, first, order, pixels) {
                for (row, pixels) in (first..).zip(pixels.chunks(width)) {
                    self.progress.row(row, &mut pixels.iter().copied());
                }
            }
        });
        if self.progress.stopped() {
            return Err(Error::Stopped);
        }
        Ok(image)
    }

    /// Renders the rows from `first` on: the mean over the samples of each pixel, for a batch
    /// of pixels at a time, in this order. False if the rendering was stopped.
    fn render_tile_row(
        &self,
        sampler: &impl Sampler,
        first: u32,
        order: &[(u32, u32)],
        pixels: &mut [Color],
    ) -> bool {
        let (samples, size) = (sampler.samples(), self.settings.size);
        let pixels_per_batch = (BATCH / samples as usize).max(1);
        let (mut positions, mut light, mut tracer) = (Vec::new(), Vec::new(), self.tracer());
        for batch in order.chunks(pixels_per_batch) {
            for start in (0..samples).step_by(BATCH) {
                if self.progress.stopped() {
                    return false;
                }
                let some = start..samples.min(start + BATCH as u32);
                positions.clear();
                for &(column, row) in batch {
                    let pixel = (column, first + row);
                    for i in some.clone() {
                        let in_pixel = sampler.place(i, pixel.0, pixel.1);
                        positions.push(image_position(size, pixel, in_pixel));
                    }
                }
                tracer(&positions, &mut light);
                for ((column, row), light) in batch.iter().zip(light.chunks(some.len())) {
                    let pixel = &mut pixels[(row * size.width() + column) as usize];
                    *pixel = light.iter().fold(*pixel, |sum, light| sum + *light);
                }
            }
        }
        if samples > 1 {
            for pixel in pixels {
                *pixel = *pixel / f64::from(samples);
            }
        }
        true
    }
}

impl Radiance for View<'_, '_> {
    fn tracer(&self) -> LightAt<'_> {
        // `dispatch!` would compile four levels for x86-64.
        #[cfg(target_arch = "x86_64")]
        if !crate::lanes::level::HAS_ONE
            && let Some(avx2) = self.level.as_avx2()
        {
            return self.tracer_with(avx2);
        }
        #[cfg(target_arch = "x86_64")]
        if let Some(sse2) = self.level.as_sse2() {
            return self.tracer_with(sse2);
        }
        #[cfg(target_arch = "x86_64")]
        unreachable!("every x86-64 processor has SSE2");
        #[cfg(not(target_arch = "x86_64"))]
        fearless_simd::dispatch!(self.level, simd => self.tracer_with(simd))
    }
}

impl View<'_, '_> {
    /// The tracer with these instructions.
    fn tracer_with<S: Simd>(&self, simd: S) -> LightAt<'_> {
        let (mut rays, mut batch) = (Vec::new(), Batch::new(simd));
        Box::new(move |positions, light| {
            steps::count(StepKind::CameraRay, positions.len() as u64);
            light.resize(positions.len(), Color::BLACK);
            simd.vectorize(
                #[inline(always)]
                || {
                    rays.clear();
                    let size = self.settings.size;
                    self.camera.rays(simd, size, positions, &mut rays);
                    self.tracer.trace(&rays, light, &mut batch);
                },
            );
        })
    }
}

/// The columns and rows of a tile row of this height, square by square.
fn squares(width: u32, height: u32) -> Vec<(u32, u32)> {
    let lefts = (0..width).step_by(TILE);
    let rows = lefts.flat_map(|left| (0..height).map(move |row| (left, row)));
    let pixels = rows.flat_map(|(left, row)| {
        let columns = left..width.min(left + TILE as u32);
        columns.map(move |column| (column, row))
    });
    pixels.collect()
}
