//! Draws the picture, and the rays over it.

use program::{Gallery, LivePicture};

use super::appearance::RAY;
use super::area::Area;
use super::frame::Frame;
use super::placement::{Footprint, Placement};
use super::screen::Screen;

/// Most pixels of the picture, along a side, whose mean is a pixel of the window.
const MOST_PIXELS: usize = 4;

impl Screen {
    /// Draws the picture, and the rays and messages over it, if one of them has changed.
    pub fn draw_picture(&mut self, gallery: &Gallery) {
        let fingerprint = self.fingerprint(gallery);
        let is_drawn = self.drawn == fingerprint;
        self.drawn = fingerprint;
        self.ui.frame.clip = self.placement.area;
        if is_drawn {
            // Their words are in the list of this layout, too.
            self.draw_messages(gallery);
            return;
        }
        if let Some(live) = &gallery.picture {
            self.draw_live(gallery, live);
        } else {
            let color = self.ui.colors.background;
            self.ui.frame.fill(self.placement.area, color);
        }
        self.draw_messages(gallery);
    }

    /// Draws the picture as far as it is known, marks of its finished rows, and the rays.
    fn draw_live(&mut self, gallery: &Gallery, live: &LivePicture) {
        let (placement, colors) = (self.placement, self.ui.colors);
        let around = [colors.background, colors.raised];
        paint(&mut self.ui.frame, &placement, live, around);
        let left = placement.in_window([0.0; 2])[0] as i32 - self.ui.px(4.0);
        let marks = Area {
            x: left.max(0),
            width: self.ui.px(3.0),
            ..placement.area
        };
        for ((_, y), mark) in self.ui.frame.rows(marks) {
            let mut rows = placement.footprint(1, y).pixels;
            if gallery.is_rendering() && rows.any(|row| live.is_finished(row)) {
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
            for (ends, fraction) in &lines {
                self.ui.frame.line(*ends, width * scale, color, *fraction);
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
    let columns = (area.x..area.x + area.width).map(|x| placement.footprint(0, x));
    let columns: Vec<_> = columns.collect();
    // An enlarged column is the same for some columns of the window, and a row for some rows.
    let columns = columns.chunk_by(PartialEq::eq);
    let columns: Vec<_> = columns.map(|equal| (&equal[0], equal.len())).collect();
    let (mut last, mut colors) = (None, Vec::new());
    for ((_, y), row) in frame.rows(area) {
        let rows = placement.footprint(1, y);
        if last.as_ref() != Some(&rows) {
            colors.clear();
            for (columns, count) in &columns {
                let color = if columns.pixels.is_empty() || rows.pixels.is_empty() {
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

/// The weighted mean colour of the pixels at these columns and rows; none if one is not known.
fn mean(live: &LivePicture, columns: &Footprint, rows: &Footprint) -> Option<u32> {
    if columns.pixels.len() == 1 && rows.pixels.len() == 1 {
        return live.pixel(columns.pixels.start, rows.pixels.start);
    }
    let (mut sums, mut weights) = ([0.0; 3], 0.0);
    for (y, height) in some(rows) {
        for (x, width) in some(columns) {
            let weight = width * height;
            let [_, color @ ..] = live.pixel(x, y)?.to_be_bytes();
            for (sum, channel) in sums.iter_mut().zip(color) {
                *sum += weight * f64::from(channel);
            }
            weights += weight;
        }
    }
    let [r, g, b] = sums.map(|sum| (sum / weights + 0.5) as u8);
    Some(u32::from_be_bytes([0, r, g, b]))
}

/// Some of the pixels of a footprint, with their weights.
fn some(all: &Footprint) -> impl Iterator<Item = (u32, f64)> {
    let step = all.pixels.len().div_ceil(MOST_PIXELS);
    let last = all.pixels.end - 1;
    let some = all.pixels.clone().step_by(step);
    some.map(move |at| (at, if at == last { all.last } else { 1.0 }))
}
