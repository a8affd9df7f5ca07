//! `LivePicture`: a picture while it is rendered, for the window that shows it.

use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::time::Instant;

use common::{Color, Image, Progress, Sampling, Scene, Settings, Size, Transfer};
use indicatif::{FormattedDuration, ProgressBar, ProgressDrawTarget};

/// The packed 0xRRGGBB pixels of a picture while it is rendered. Before a row is finished, it
/// shows a coarse picture, if there is one.
///
/// All threads of the rendering write it, and the window's thread reads it, without
/// a lock: a pixel is one number, and the window soon shows it again.
#[derive(Debug)]
pub struct LivePicture {
    size: Size,
    transfer: Transfer,
    /// Each with `COARSE` or `FINAL` above the colour; 0 where nothing is known.
    pixels: Vec<AtomicU32>,
    changes: AtomicU32,
    /// Counts rows, and is not drawn; a row that is painted again counts again.
    bar: ProgressBar,
    stopped: AtomicBool,
    /// The time when the rendering began, which differs between two pictures.
    pub started: Instant,
}

const COARSE: u32 = 1 << 24;
const FINAL: u32 = 2 << 24;

impl LivePicture {
    /// A picture without a finished row.
    #[must_use]
    pub fn new(size: Size, transfer: Transfer) -> Self {
        let (rows, hidden) = (size.height().into(), ProgressDrawTarget::hidden());
        Self {
            size,
            transfer,
            pixels: (0..size.pixels()).map(|_| AtomicU32::new(0)).collect(),
            changes: AtomicU32::new(0),
            bar: ProgressBar::with_draw_target(Some(rows), hidden),
            stopped: AtomicBool::new(false),
            started: Instant::now(),
        }
    }

    /// Width and height.
    #[must_use]
    pub const fn size(&self) -> Size {
        self.size
    }

    /// The current colour of a pixel inside of the picture; none before there is one.
    #[inline]
    #[must_use]
    pub fn pixel(&self, x: u32, y: u32) -> Option<u32> {
        let pixel = self.load(x, y);
        (pixel >= COARSE).then_some(pixel & 0xFF_FFFF)
    }

    /// Whether a row inside of the picture is finished.
    #[must_use]
    pub fn is_finished(&self, y: u32) -> bool {
        self.load(0, y) >= FINAL
    }

    #[inline]
    fn load(&self, x: u32, y: u32) -> u32 {
        let index = y as usize * self.size.width() as usize + x as usize;
        self.pixels[index].load(Ordering::Relaxed)
    }

    /// A number that grows with each change of the picture; 0 for an empty one.
    #[must_use]
    pub fn changes(&self) -> u32 {
        self.changes.load(Ordering::Relaxed)
    }

    /// Shows an earlier picture of the same size until this one has pixels.
    pub fn begin_with(&self, earlier: &Self) {
        let is_same = self.size == earlier.size;
        for (pixel, earlier) in self.pixels.iter().zip(&earlier.pixels).filter(|_| is_same) {
            let earlier = earlier.load(Ordering::Relaxed);
            pixel.store(earlier.min(COARSE) | earlier & 0xFF_FFFF, Ordering::Relaxed);
        }
    }

    /// Shows a finished picture.
    pub fn finish(&self, image: &Image) {
        for (y, row) in (0..).zip(image.rows()) {
            self.paint(y, &mut row.iter().copied(), FINAL);
        }
    }

    fn paint(&self, y: u32, pixels: &mut dyn Iterator<Item = Color>, state: u32) {
        let width = self.size.width() as usize;
        let row = self.pixels.iter().skip(y as usize * width).take(width);
        for (live, color) in row.zip(pixels) {
            live.store(self.transfer.pack(color) | state, Ordering::Relaxed);
        }
        self.changes.fetch_add(1, Ordering::Relaxed);
    }

    /// The finished fraction of the work known so far, from 0 to 1.
    #[must_use]
    pub fn fraction(&self) -> f64 {
        self.bar.position() as f64 / self.bar.length().unwrap_or(1) as f64
    }

    /// The time since the rendering began, and the time for the remaining rows as soon as one row is
    /// finished, in words.
    #[must_use]
    pub fn times(&self) -> String {
        let [elapsed, to_go] = [self.bar.elapsed(), self.bar.eta()].map(FormattedDuration);
        if self.bar.position() == 0 {
            return format!("{elapsed} elapsed");
        }
        format!("{elapsed} elapsed, {to_go} to go")
    }

    /// Ends the rendering after the rows that are being painted.
    pub fn stop(&self) {
        self.stopped.store(true, Ordering::Relaxed);
    }
}

impl Progress for LivePicture {
    fn row(&self, y: u32, pixels: &mut dyn Iterator<Item = Color>) {
        self.paint(y, pixels, FINAL);
        self.bar.inc(1);
    }

    fn more_rows(&self, rows: u32) {
        self.bar.inc_length(rows.into());
    }

    fn stopped(&self) -> bool {
        self.stopped.load(Ordering::Relaxed)
    }
}

/// Paints a coarse picture, whose pixels are squares of this side, into a live one.
pub struct Coarse<'a>(pub &'a LivePicture, pub u32);

impl Progress for Coarse<'_> {
    fn row(&self, y: u32, pixels: &mut dyn Iterator<Item = Color>) {
        let Self(live, side) = *self;
        let row: Vec<_> = pixels
            .flat_map(|color| std::iter::repeat_n(color, side as usize))
            .collect();
        for y in (y * side)..((y + 1) * side).min(live.size.height()) {
            live.paint(y, &mut row.iter().copied(), COARSE);
        }
    }

    fn stopped(&self) -> bool {
        self.0.stopped()
    }
}

/// The sides of the pixels of coarse pictures that are rendered first, and the settings. All
/// together take a small part of the time of the picture.
pub fn coarse(scene: &Scene, settings: &Settings) -> impl Iterator<Item = (u32, Settings)> {
    let has_rays = scene.rays().is_ok();
    let (size, samples) = (settings.size, settings.samples);
    let sides = [8, 4, 2, 1].into_iter();
    sides
        .filter(move |side| has_rays && samples.saturating_mul(side * side) >= 16)
        .map(move |side| {
            let size = Size::new(size.width().div_ceil(side), size.height().div_ceil(side));
            let settings = Settings {
                size: size.unwrap_or(settings.size),
                samples: 1,
                sampling: Sampling::Center,
                max_error: None,
                ..settings.clone()
            };
            (side, settings)
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_appear_where_they_belong_and_are_counted() {
        let picture = LivePicture::new(Size::new(3, 4).unwrap(), Transfer::Linear);
        let row = |y| [0, 1, 2].map(|x| picture.pixel(x, y));
        let [red, green, white] = [0xFF_0000, 0x00_FF00, 0xFF_FFFF].map(Some);
        Coarse(&picture, 2).row(1, &mut [Color::RED, Color::GREEN].into_iter());
        assert_eq!((row(2), row(3)), ([red, red, green], [red, red, green]));
        assert!(!picture.is_finished(2));
        picture.row(2, &mut [Color::RED, Color::GREEN, Color::WHITE].into_iter());
        assert_eq!((row(1), row(2)), ([None; 3], [red, green, white]));
        assert!(picture.is_finished(2));
        assert_eq!(picture.fraction(), 0.25);

        for y in [0, 1, 3] {
            picture.row(y, &mut [Color::BLACK; 3].into_iter());
        }
        // A row that is painted again is work, too.
        picture.more_rows(1);
        assert_eq!(picture.fraction(), 0.8);
        picture.row(2, &mut [Color::WHITE; 3].into_iter());
        assert_eq!((picture.fraction(), picture.pixel(0, 2)), (1.0, white));
    }
}
