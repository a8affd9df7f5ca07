//! Draws the picture, the rays over it, and the items beside it.

use program::{Gallery, LivePicture};

use super::appearance::{Colors, RAY};
use super::command::Command;
use super::content::{Content, Item, Kind};
use super::frame::{Area, Frame};
use super::placement::Placement;
use super::screen::Screen;

/// Most places of the picture, along a side, whose mean is a pixel of the window.
const MOST_PLACES: u32 = 4;

impl Screen {
    /// Draws the window.
    pub fn draw(&mut self, content: &Content, gallery: &Gallery) {
        let (colors, placement) = (Colors::of(self.theme), &content.placement);
        let mut frame = std::mem::take(&mut self.frame);
        frame.resize(self.window.get_size());
        frame.clip(placement.area);
        frame.fill(placement.area, colors.background);
        if let Some(live) = &gallery.picture {
            paint(&mut frame, placement, live, |x, y| {
                let is_even = (x + y) / self.ui(6.0).max(1) % 2 == 0;
                if is_even { colors.raised } else { colors.bar }
            });
            let left = placement.in_window([0.0, 0.0]).0 as i32 - self.ui(4.0);
            for y in placement.area.y..placement.area.y + placement.area.height {
                let row = placement.rows(y, 1).next().flatten();
                if gallery.outcome.is_none() && row.is_some_and(|row| live.is_finished(row)) {
                    frame.fill(Area::new(left.max(0), y, self.ui(3.0), 1), colors.accent);
                }
            }
        }
        self.draw_rays(&mut frame, placement, gallery);
        frame.clip(Area::new(0, 0, i32::MAX, i32::MAX));
        for item in &content.items {
            self.draw_item(&mut frame, item, colors);
        }
        self.frame = frame;
    }

    /// Draws a square around the pixel that is explained, and its rays, fainter where hidden.
    fn draw_rays(&self, frame: &mut Frame, placement: &Placement, gallery: &Gallery) {
        let Some([x, y]) = gallery.pixel else { return };
        let half = (placement.scale / 2.0).max(4.0 * self.scale);
        let (x, y) = placement.in_window([f64::from(x) + 0.5, f64::from(y) + 0.5]);
        let corners = [
            (-half, -half),
            (half, -half),
            (half, half),
            (-half, half),
            (-half, -half),
        ];
        let corners = corners.map(|(right, down)| (x + right, y + down));
        let mut lines: Vec<_> = corners
            .windows(2)
            .map(|ends| ([ends[0], ends[1]], 1.0))
            .collect();
        if let Some(Ok(explanation)) = &gallery.explanation {
            lines.extend(explanation.rays.iter().map(|ray| {
                let ends = ray.ends.map(|end| placement.in_window(end));
                (ends, if ray.is_hidden { 0.25 } else { 1.0 })
            }));
        }
        for (color, width) in [(0, 3.5), (RAY, 1.5)] {
            for (ends, share) in &lines {
                frame.line(*ends, width * self.scale, color, *share);
            }
        }
    }

    fn draw_item(&mut self, frame: &mut Frame, item: &Item, colors: &Colors) {
        let is_page =
            item.command == self.page.map(Command::Page) && matches!(item.kind, Kind::Text);
        if item.command.is_some() && (is_page || item.command == self.selected) {
            frame.fill(item.area.inset(self.ui(-8.0), self.ui(1.0)), colors.raised);
        }
        let (mut area, mut color) = (item.area, colors.text);
        let (left, middle) = (
            f64::from(area.x),
            f64::from(area.y) + f64::from(area.height) / 2.0,
        );
        match item.kind {
            Kind::Bar => frame.fill(area, colors.bar),
            Kind::Muted => color = colors.muted,
            Kind::Color(color) => frame.fill(area.inset(0, self.ui(3.0)), color),
            Kind::Progress(share) => {
                area.width = (f64::from(area.width) * share) as i32;
                frame.fill(area, colors.accent);
            }
            Kind::Entry(true) => {
                let dot = (left - 10.0 * self.scale, middle);
                frame.line([dot, dot], 6.0 * self.scale, colors.accent, 1.0);
            }
            Kind::Slider(share) => {
                let y = middle + 11.0 * self.scale;
                let end = |share: f64| (left + f64::from(area.width) * share, y);
                frame.line([end(0.0), end(1.0)], 3.0 * self.scale, colors.muted, 0.5);
                frame.line([end(0.0), end(share)], 3.0 * self.scale, colors.accent, 1.0);
                frame.line([end(share); 2], 12.0 * self.scale, colors.accent, 1.0);
                area.height = self.ui(24.0);
            }
            Kind::Text | Kind::Entry(false) => {}
        }
        self.letters.write(frame, area, color, &item.text);
        let (text, value) = (
            self.letters.width(&item.text),
            self.letters.width(&item.value),
        );
        if text + value <= area.width {
            area.x += area.width - value;
            self.letters.write(frame, area, colors.muted, &item.value);
        }
    }
}

/// Paints a picture. The colour of places that are not known yet depends on their place in the
/// window.
fn paint(
    frame: &mut Frame,
    placement: &Placement,
    live: &LivePicture,
    unknown: impl Fn(i32, i32) -> u32,
) {
    let places = ((1.0 / placement.scale).ceil() as u32).clamp(1, MOST_PLACES);
    let area = placement.area;
    let pixels = (area.x..area.x + area.width).map(|x| {
        let columns: Option<Vec<_>> = placement.columns(x, places).collect();
        Some((x, columns?))
    });
    let columns: Vec<_> = pixels.flatten().collect();
    let Some((left, _)) = columns.first() else {
        return;
    };
    let area = Area::new(*left, area.y, columns.len() as i32, area.height);
    let mut last = (Vec::new(), Vec::new());
    for ((_, y), row) in frame.rows(area) {
        let Some(rows) = placement.rows(y, places).collect::<Option<Vec<_>>>() else {
            continue;
        };
        // An enlarged row is the same for some rows of the window.
        if last.0 == rows {
            row.copy_from_slice(&last.1);
            continue;
        }
        let mut is_known = true;
        for ((x, columns), pixel) in columns.iter().zip(&mut *row) {
            let color = mean(live, columns, &rows);
            is_known &= color.is_some();
            *pixel = color.unwrap_or_else(|| unknown(*x, y));
        }
        last = (if is_known { rows } else { Vec::new() }, row.to_vec());
    }
}

/// The mean colour at some columns and rows; none if one is not known.
fn mean(live: &LivePicture, columns: &[u32], rows: &[u32]) -> Option<u32> {
    if let ([x], [y]) = (columns, rows) {
        return live.pixel(*x, *y);
    }
    let mut sums = [0; 3];
    for (x, y) in rows
        .iter()
        .flat_map(|y| columns.iter().map(move |x| (*x, *y)))
    {
        let [_, color @ ..] = live.pixel(x, y)?.to_be_bytes();
        for (sum, channel) in sums.iter_mut().zip(color) {
            *sum += u32::from(channel);
        }
    }
    let count = (columns.len() * rows.len()) as u32;
    let [r, g, b] = sums.map(|sum| ((sum + count / 2) / count) as u8);
    Some(u32::from_be_bytes([0, r, g, b]))
}
