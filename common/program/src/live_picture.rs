//! `LivePicture`: a picture while it is rendered, for the window that shows it.

use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::time::{Duration, Instant};

use common::{Color, Progress, Size, Transfer};

/// The packed 0xRRGGBB pixels of a picture while it is rendered. Unfinished rows
/// are black.
///
/// All threads of the rendering write it, and the window's thread reads it, without
/// a lock: a pixel is one number, and the window soon shows it again.
#[derive(Debug)]
pub struct LivePicture {
    size: Size,
    transfer: Transfer,
    pixels: Vec<AtomicU32>,
    rows: AtomicU32,
    /// The number of rows to paint; a row that is painted again counts again.
    rows_to_paint: AtomicU32,
    stopped: AtomicBool,
    started: Instant,
}

impl LivePicture {
    /// A picture without a finished row.
    #[must_use]
    pub fn new(size: Size, transfer: Transfer) -> Self {
        Self {
            size,
            transfer,
            pixels: (0..size.pixels()).map(|_| AtomicU32::new(0)).collect(),
            rows: AtomicU32::new(0),
            rows_to_paint: AtomicU32::new(size.height()),
            stopped: AtomicBool::new(false),
            started: Instant::now(),
        }
    }

    /// Width and height.
    #[must_use]
    pub const fn size(&self) -> Size {
        self.size
    }

    /// The current value of a pixel, counted row after row from the top.
    #[must_use]
    pub fn pixel(&self, index: usize) -> Option<u32> {
        let pixel = self.pixels.get(index)?;
        Some(pixel.load(Ordering::Relaxed))
    }

    /// The number of finished rows; a row that is painted again counts again.
    #[must_use]
    pub fn rows(&self) -> u32 {
        self.rows.load(Ordering::Relaxed)
    }

    /// The finished share of the work known so far, from 0 to 1.
    #[must_use]
    pub fn share(&self) -> f64 {
        let all = self.rows_to_paint.load(Ordering::Relaxed);
        f64::from(self.rows()) / f64::from(all)
    }

    /// The time since the rendering began.
    #[must_use]
    pub fn elapsed(&self) -> Duration {
        self.started.elapsed()
    }

    /// The time for the remaining rows, if they take as long as the finished ones.
    /// None before a row is finished.
    #[must_use]
    pub fn remaining(&self) -> Option<Duration> {
        let share = self.share().min(1.0);
        let to_go = (1.0 - share) / share;
        Duration::try_from_secs_f64(self.elapsed().as_secs_f64() * to_go).ok()
    }

    /// Ends the rendering after the rows that are being painted.
    pub fn stop(&self) {
        self.stopped.store(true, Ordering::Relaxed);
    }
}

impl Progress for LivePicture {
    fn row(&self, y: u32, pixels: &mut dyn Iterator<Item = Color>) {
        let width = self.size.width() as usize;
        let start = y as usize * width;
        for (live, color) in self.pixels[start..start + width].iter().zip(pixels) {
            live.store(self.transfer.pack(color), Ordering::Relaxed);
        }
        self.rows.fetch_add(1, Ordering::Relaxed);
    }

    fn more_rows(&self, rows: u32) {
        self.rows_to_paint.fetch_add(rows, Ordering::Relaxed);
    }

    fn stopped(&self) -> bool {
        self.stopped.load(Ordering::Relaxed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A picture of 3x4 pixels that has taken a minute. One of four rows leaves three minutes
    /// for the others.
    #[test]
    fn rows_appear_where_they_belong_and_tell_the_remaining_time() {
        let minute = Duration::from_mins(1);
        let picture = LivePicture {
            started: Instant::now().checked_sub(minute).unwrap(),
            ..LivePicture::new(Size::new(3, 4).unwrap(), Transfer::Linear)
        };
        assert_eq!(picture.remaining(), None);
        picture.row(2, &mut [Color::RED, Color::GREEN, Color::WHITE].into_iter());
        let pixels = [5, 6, 7, 8, 9, 12].map(|index| picture.pixel(index));
        let [red, green, white] = [0xFF_0000, 0x00_FF00, 0xFF_FFFF].map(Some);
        assert_eq!(pixels, [Some(0), red, green, white, Some(0), None]);
        let remaining = picture.remaining().unwrap();
        assert!((3 * minute..4 * minute).contains(&remaining));

        for y in [0, 1, 3] {
            picture.row(y, &mut [Color::BLACK; 3].into_iter());
        }
        assert_eq!(picture.remaining(), Some(Duration::ZERO));
        // A row that is painted again is work, too.
        picture.more_rows(1);
        assert_eq!(picture.share(), 0.8);
        picture.row(2, &mut [Color::WHITE; 3].into_iter());
        assert_eq!((picture.share(), picture.pixel(6)), (1.0, white));
    }
}
