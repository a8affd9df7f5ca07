//! Draws the picture, and the rays over it.

use std::ops::Range;

use program::{Gallery, LivePicture};

use super::appearance::RAY;
use super::area::Area;
use super::frame::Frame;
use super::placement::Placement;
use super::screen::Screen;

/// Most pixels of the picture, along a side, whose mean is a pixel of the window.
const MOST_PIXELS: usize = 4;

impl Screen {
    /// Draws the picture and the rays over it, if they have changed.
    pub fn draw(&mut self, gallery: &Gallery) {
        let look = self.look(gallery);
        if self.drawn == look {
            return;
        }
        self.drawn = look;
        let (placement, colors) = (self.placement, self.ui.colors);
        self.ui.frame.clip = placement.area;
        let Some(live) = &gallery.picture else {
            return self.ui.frame.fill(placement.area, colors.background);
        };
        let around = [colors.background, colors.raised];
        paint(&mut self.ui.frame, &placement, live, around);
        let left = placement.in_window([0.0; 2])[0] as i32 - self.ui.px(4.0);
        let marks = Area {
            x: left.max(0),
            width: self.ui.px(3.0),
            ..placement.area
        };
        for ((_, y), mark) in self.ui.frame.rows(marks) {
            let mut rows = placement.pixels(1, y);
            if gallery.outcome.is_none() && rows.any(|row| live.is_finished(row)) {
                mark.fill(colors.accent);
            }
        }
        self.draw_rays(gallery);
    }

    /// Draws a square around the pixel that is explained, and its rays, fainter where hidden.
    fn draw_rays(&mut self, gallery: &Gallery) {
        let Some(pixel) = gallery.pixel else { return };
        let (placement, scale) = (self.placement, self.ui.scale);
        let half = (placement.scale / 2.0).max(4.0 * scale);
        let [x, y] = placement.in_window(pixel.map(|at| f64::from(at) + 0.5));
        let corners = [
            (-1.0, -1.0),
            (1.0, -1.0),
            (1.0, 1.0),
            (-1.0, 1.0),
            (-1.0, -1.0),
        ]
        .map(|(right, down)| [x + half * right, y + half * down]);
        let sides = corners.windows(2).map(|ends| ([ends[0], ends[1]], 1.0));
        let mut lines: Vec<_> = sides.collect();
        if let Some(Ok(explanation)) = &gallery.explanation {
            lines.extend(explanation.rays.iter().map(|ray| {
                let ends = ray.ends.map(|end| placement.in_window(end));
                (ends, if ray.is_hidden { 0.25 } else { 1.0 })
            }));
        }
        for (color, width) in [(0, 3.5), (RAY, 1.5)] {
            for (ends, share) in &lines {
                self.ui.frame.line(*ends, width * scale, color, *share);
            }
        }
    }
}

/// Paints a picture, with a colour beside it and one for places that are not known yet.
fn paint(
    frame: &mut Frame,
    placement: &Placement,
    live: &LivePicture,
    [background, unknown]: [u32; 2],
) {
    let area = placement.area;
    let columns = (area.x..area.x + area.width).map(|x| placement.pixels(0, x));
    let columns: Vec<_> = columns.collect();
    // An enlarged column is the same for some columns of the window, and a row for some rows.
    let columns = columns.chunk_by(PartialEq::eq);
    let columns: Vec<_> = columns.map(|equal| (&equal[0], equal.len())).collect();
    let (mut last, mut colors) = (None, Vec::new());
    for ((_, y), row) in frame.rows(area) {
        let rows = placement.pixels(1, y);
        if last.as_ref() != Some(&rows) {
            colors.clear();
            for (columns, count) in &columns {
                let color = if columns.is_empty() || rows.is_empty() {
                    background
                } else {
                    mean(live, columns, &rows).unwrap_or(unknown)
                };
                colors.extend(std::iter::repeat_n(color, *count));
            }
            last = Some(rows);
        }
        row.copy_from_slice(&colors);
    }
}

/// The mean colour of some pixels at these columns and rows; none if one is not known.
fn mean(live: &LivePicture, columns: &Range<u32>, rows: &Range<u32>) -> Option<u32> {
    if columns.len() == 1 && rows.len() == 1 {
        return live.pixel(columns.start, rows.start);
    }
    let some = |all: &Range<u32>| all.clone().step_by(all.len().div_ceil(MOST_PIXELS));
    let (mut sums, mut count) = ([0; 3], 0);
    for (x, y) in some(rows).flat_map(|y| some(columns).map(move |x| (x, y))) {
        let [_, color @ ..] = live.pixel(x, y)?.to_be_bytes();
        for (sum, channel) in sums.iter_mut().zip(color) {
            *sum += u32::from(channel);
        }
        count += 1;
    }
    let [r, g, b] = sums.map(|sum| ((sum + count / 2) / count) as u8);
    Some(u32::from_be_bytes([0, r, g, b]))
}
