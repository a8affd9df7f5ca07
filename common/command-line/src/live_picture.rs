//! `LivePicture`: a picture while it is rendered, for the window that shows it.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::time::{Duration, Instant};

use common::{Color, Error, Image, Progress, Sampling, Scene, Settings, Size, Transfer};
use indicatif::{ProgressBar, ProgressDrawTarget};

use crate::terminal_progress::{Elapsed, set_fraction};

/// The packed 0xRRGGBB pixels of a picture while it is rendered; black where nothing is known.
///
/// All threads of the rendering write it, and the window's thread reads it, without
/// a lock: a pixel is one number, and the window soon shows it again.
#[derive(Debug)]
pub struct LivePicture {
    size: Size,
    transfer: Transfer,
    pixels: Vec<AtomicU32>,
    changes: AtomicU32,
    /// Counts rows, or fractions where they are told; it is not drawn.
    bar: ProgressBar,
    stopped: AtomicBool,
    /// When the rendering began.
    began: Instant,
    /// The time that it took.
    took: OnceLock<Duration>,
}

impl LivePicture {
    /// A black picture.
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
            began: Instant::now(),
            took: OnceLock::new(),
        }
    }

    /// Width and height.
    #[must_use]
    pub const fn size(&self) -> Size {
        self.size
    }

    /// The current colour of a pixel; black beside the picture.
    #[inline]
    #[must_use]
    pub fn pixel(&self, x: u32, y: u32) -> u32 {
        let index = y as usize * self.size.width() as usize + x as usize;
        let pixel = self.pixels.get(index);
        pixel.map_or(0, |pixel| pixel.load(Ordering::Relaxed))
    }

    /// A number that grows with each change of the picture; 0 for an empty one.
    #[must_use]
    pub fn changes(&self) -> u32 {
        self.changes.load(Ordering::Relaxed)
    }

    /// Shows an earlier picture of the same size until this one has pixels.
    pub fn begin_with(&self, earlier: &Self) {
        if self.size != earlier.size {
            return;
        }
        for (pixel, earlier) in self.pixels.iter().zip(&earlier.pixels) {
            pixel.store(earlier.load(Ordering::Relaxed), Ordering::Relaxed);
        }
    }

    /// Renders a scene into this picture: first coarse pictures, which together take a small part of the
    /// time, and then the picture itself, row by row.
    pub fn render(&self, scene: &Scene, settings: &Settings) -> Result<Image, Error> {
        for side in coarse_sides(scene, settings) {
            let [width, height] = [settings.size.width(), settings.size.height()];
            let coarse = Settings {
                size: Size::new(width.div_ceil(side), height.div_ceil(side))?,
                samples: 1,
                sampling: Sampling::Center,
                max_error: None,
                ..settings.clone()
            };
            // The last rendering reports an error.
            let _ = scene.render(&coarse, &Squares { live: self, side });
        }
        scene.render(settings, self)
    }

    /// Shows a finished picture; one of another size has no place here.
    pub fn finish(&self, image: &Image) {
        if self.size != image.size() {
            return;
        }
        for (y, row) in (0..).zip(image.rows()) {
            self.paint(y, &mut row.iter().copied());
        }
        self.took.get_or_init(|| self.began.elapsed());
    }

    /// The same rendering with its finished picture, which has another size.
    pub(crate) fn replaced_by(&self, image: &Image) -> Self {
        let mut picture = Self::new(image.size(), self.transfer);
        picture.began = self.began;
        picture.finish(image);
        picture
    }

    fn paint(&self, y: u32, pixels: &mut dyn Iterator<Item = Color>) {
        let width = self.size.width() as usize;
        let row = self.pixels.iter().skip(y as usize * width).take(width);
        for (live, color) in row.zip(pixels) {
            live.store(self.transfer.pack(color), Ordering::Relaxed);
        }
        self.changes.fetch_add(1, Ordering::Relaxed);
    }

    /// The finished fraction of the work known so far, from 0 to 1.
    #[must_use]
    pub fn fraction(&self) -> f64 {
        self.bar.position() as f64 / self.bar.length().unwrap_or(1) as f64
    }

    /// In words, the time that the rendering took; before its end the time since it began, and the time
    /// for the remaining rows as soon as one row is finished.
    #[must_use]
    pub fn times(&self) -> String {
        if let Some(took) = self.took.get() {
            return format!("{:.2} s", took.as_secs_f64());
        }
        Elapsed::of(&self.bar).words()
    }

    /// Whether the rendering takes so long that a faster renderer is worth a remark.
    #[must_use]
    pub fn is_slow(&self) -> bool {
        Elapsed::of(&self.bar).is_slow()
    }

    /// Ends the rendering after the rows that are being painted.
    pub fn stop(&self) {
        self.stopped.store(true, Ordering::Relaxed);
    }
}

impl Progress for LivePicture {
    fn row(&self, y: u32, pixels: &mut dyn Iterator<Item = Color>) {
        self.paint(y, pixels);
        self.bar.inc(1);
    }

    fn done(&self, fraction: f64) {
        set_fraction(&self.bar, fraction);
    }

    fn stopped(&self) -> bool {
        self.stopped.load(Ordering::Relaxed)
    }
}

/// Paints a coarse picture, whose pixels are squares of this side, into a live one.
struct Squares<'a> {
    live: &'a LivePicture,
    side: u32,
}

impl Progress for Squares<'_> {
    fn row(&self, y: u32, pixels: &mut dyn Iterator<Item = Color>) {
        let row: Vec<_> = pixels
            .flat_map(|color| std::iter::repeat_n(color, self.side as usize))
            .collect();
        for y in (y * self.side)..((y + 1) * self.side).min(self.live.size.height()) {
            self.live.paint(y, &mut row.iter().copied());
        }
    }

    fn stopped(&self) -> bool {
        self.live.stopped()
    }
}

/// The sides of the squares of the coarse pictures. The squares of a large picture are no smaller than the
/// pixels of a window.
fn coarse_sides(scene: &Scene, settings: &Settings) -> Vec<u32> {
    let mut sides = vec![8, 4, 2, 1];
    sides.retain(|side| {
        let is_cheap = settings.samples.saturating_mul(side * side) >= 16;
        let is_seen = *side >= settings.size.width() / 1280;
        scene.rays().is_ok() && is_cheap && is_seen
    });
    sides
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_appear_where_they_belong_and_are_counted() {
        let live = LivePicture::new(Size::new(3, 4).unwrap(), Transfer::Linear);
        let row = |y| [0, 1, 2].map(|x| live.pixel(x, y));
        let [red, green, white] = [0xFF_0000, 0x00_FF00, 0xFF_FFFF];
        let squares = Squares {
            live: &live,
            side: 2,
        };
        squares.row(1, &mut [Color::RED, Color::GREEN].into_iter());
        assert_eq!((row(2), row(3)), ([red, red, green], [red, red, green]));
        live.row(2, &mut [Color::RED, Color::GREEN, Color::WHITE].into_iter());
        assert_eq!((row(1), row(2)), ([0; 3], [red, green, white]));
        assert_eq!(live.fraction(), 0.25);

        for y in [0, 1, 3] {
            live.row(y, &mut [Color::BLACK; 3].into_iter());
        }
        assert_eq!(live.fraction(), 1.0);
        // Where rows are painted again, they do not tell the fraction.
        live.done(0.5);
        live.row(2, &mut [Color::WHITE; 3].into_iter());
        assert_eq!(live.pixel(0, 2), white);
        assert!((live.fraction() - 0.5).abs() < 1e-9);
    }
}
