//! `View`: a picture being rendered, two rows at a time.
//!
//! Four rays through a square of pixels stay closer together than four of a row, so that they
//! more often meet the same shapes.

use common::tally::{self, Work};
use common::{Color, Error, Image, Progress, Settings};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use crate::adaptive::Radiance;
use crate::lanes::RayPacket;
use crate::trace::{BATCH, Batch};
use crate::{Renderer, Sampler, camera_place};

/// Rows of a strip, which are painted together.
const STRIP: usize = 2;

/// A picture being rendered.
pub(crate) struct View<'v, 'a> {
    pub renderer: &'v Renderer<'a>,
    pub settings: &'v Settings,
    pub progress: &'v dyn Progress,
}

impl View<'_, '_> {
    /// The picture, with the sampler's number of samples in each pixel.
    pub fn render(&self, sampler: &impl Sampler) -> Result<Image, Error> {
        let size = self.settings.size;
        let width = size.width() as usize;
        let mut image = Image::black(size)?;
        // The last strip may have fewer rows.
        let orders: [_; STRIP] = std::array::from_fn(|i| squares(size.width(), i as u32 + 1));
        let strips = image.pixels_mut().par_chunks_mut(STRIP * width).enumerate();
        // Each strip is a task, because one may take far longer than another.
        strips.with_max_len(1).for_each(|(strip, pixels)| {
            let first = (STRIP * strip) as u32;
            let order = &orders[pixels.len() / width - 1];
            if self.paint(sampler, first, order, pixels) {
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

    /// Paints the rows from `first` on: the mean over the samples of each pixel, for a batch
    /// of pixels at a time, in this order. False if the rendering was stopped.
    fn paint(
        &self,
        sampler: &impl Sampler,
        first: u32,
        order: &[(u32, u32)],
        pixels: &mut [Color],
    ) -> bool {
        let (samples, size) = (sampler.samples(), self.settings.size);
        let at_once = (BATCH / samples as usize).max(1);
        let (mut places, mut memory) = (Vec::new(), Memory::default());
        for some in order.chunks(at_once) {
            for start in (0..samples).step_by(BATCH) {
                if self.progress.stopped() {
                    return false;
                }
                let now = start..samples.min(start + BATCH as u32);
                places.clear();
                for &(column, row) in some {
                    let pixel = (column, first + row);
                    for i in now.clone() {
                        let place = sampler.place(i, pixel.0, pixel.1);
                        places.push(camera_place(size, pixel, place));
                    }
                }
                let light = self.light(&places, &mut memory);
                for ((column, row), light) in some.iter().zip(light.chunks(now.len())) {
                    let pixel = &mut pixels[(row * size.width() + column) as usize];
                    *pixel = light.iter().fold(*pixel, |sum, light| sum + *light);
                }
            }
        }
        if samples > 1 {
            for pixel in pixels {
                *pixel = pixel.map(|channel| channel / f64::from(samples));
            }
        }
        true
    }
}

/// Memory that one batch after the other uses.
#[derive(Default)]
pub(crate) struct Memory {
    rays: Vec<RayPacket>,
    batch: Batch,
    light: Vec<Color>,
}

impl Radiance for View<'_, '_> {
    type Memory = Memory;

    fn light<'m>(&self, places: &[(f64, f64)], memory: &'m mut Memory) -> &'m [Color] {
        let Renderer { camera, tracer, .. } = self.renderer;
        let Memory { rays, batch, light } = memory;
        rays.clear();
        camera.rays(self.settings.size, places, rays);
        tally::count_all(Work::PrimaryRay, places.len() as u64);
        light.resize(places.len(), Color::BLACK);
        tracer.trace(rays, light, batch);
        light
    }
}

/// The columns and rows of a strip of this height, square by square.
fn squares(width: u32, height: u32) -> Vec<(u32, u32)> {
    let lefts = (0..width).step_by(STRIP);
    let rows = lefts.flat_map(|left| (0..height).map(move |row| (left, row)));
    let pixels = rows.flat_map(|(left, row)| {
        let columns = left..width.min(left + STRIP as u32);
        columns.map(move |column| (column, row))
    });
    pixels.collect()
}
