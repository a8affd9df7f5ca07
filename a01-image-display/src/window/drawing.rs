//! Draws the content of the window: the picture, the lines below it, the menu above.

use std::time::Duration;

use program::LivePicture;

use super::command;
use super::frame::{Area, LETTER, LINE};
use super::menu_bar::PLATFORM_HAS_MENU;
use super::placement::Placement;
use super::screen::Screen;
use super::text;

const BACKGROUND: u32 = 0x18_1818;
const STRIP: u32 = 0x2B_2B2B;
const DONE: u32 = 0x3D_5A80;
const TEXT: u32 = 0xE0_E0E0;

impl Screen {
    /// The placement of the picture at the current size of the window.
    pub fn placement(&self) -> Placement {
        let (width, height) = self.window.get_size();
        let bar = if PLATFORM_HAS_MENU { 0 } else { LINE };
        let area = Area {
            x: 0,
            y: bar,
            width: width as i32,
            height: (height as i32 - bar).max(1),
        };
        Placement::new(self.size, area, self.zoom)
    }

    /// Draws picture, texts and menu into the frame.
    pub fn draw(&mut self, live: Option<&LivePicture>, cursor: Option<(i32, i32)>) {
        if let Some(live) = live {
            self.size = live.size();
        }
        let placement = self.placement();
        let (pixels, row_length) = (&self.pixels, self.size.width());
        let color = |(column, row): (u32, u32)| {
            let index = (row * row_length + column) as usize;
            live.map_or_else(|| pixels.get(index).copied(), |live| live.pixel(index))
        };
        self.frame.clear(self.window.get_size(), BACKGROUND);
        self.frame.paint(placement.area(), |x, y| {
            placement.pixel(x, y).and_then(color)
        });

        let mut texts = Vec::new();
        if self.helps {
            texts.push(command::HELP.to_owned());
        }
        if self.inspects {
            let at = cursor.and_then(|(x, y)| placement.pixel(x, y));
            texts.push(inspect(at, at.and_then(color)));
        }
        if let Some(Err(error)) = &self.outcome {
            texts.push(error.clone());
        }
        texts.extend(self.notice().map(str::to_owned));
        let Area {
            y, width, height, ..
        } = placement.area();
        let mut bottom = y + height;
        if let Some(live) = live {
            bottom -= LINE;
            let text = progress(live.share(), live.elapsed(), live.remaining());
            self.draw_line(&text, bottom, live.share());
        }
        let columns = (width / LETTER - 2).max(1) as usize;
        for text in texts {
            for line in text::wrap(&text, columns).into_iter().rev() {
                bottom -= LINE;
                self.draw_line(line, bottom, 0.0);
            }
        }
        if !PLATFORM_HAS_MENU {
            self.menu.draw(&mut self.frame, width, &self.title);
        }
    }

    /// Writes a line; this share of its background, from 0 to 1, has the colour of finished work.
    fn draw_line(&mut self, text: &str, y: i32, share: f64) {
        let width = self.placement().area().width;
        let done = f64::from(width) * share;
        self.frame.fill(Area::line(y, width), STRIP);
        self.frame.fill(Area::line(y, done as i32), DONE);
        self.frame.text(LETTER, y + 5, TEXT, text);
    }
}

fn progress(share: f64, elapsed: Duration, remaining: Option<Duration>) -> String {
    let clock = |time: Duration| format!("{}:{:02}", time.as_secs() / 60, time.as_secs() % 60);
    let (percent, elapsed) = (100.0 * share, clock(elapsed));
    let remaining = remaining.map_or("?".to_owned(), clock);
    format!("{percent:3.0} %  {elapsed} elapsed, {remaining} to go")
}

fn inspect(at: Option<(u32, u32)>, color: Option<u32>) -> String {
    let (Some((column, row)), Some(packed)) = (at, color) else {
        return "point at the picture".to_owned();
    };
    let [_, r, g, b] = packed.to_be_bytes();
    format!("column {column}, row {row}: #{packed:06x} ({r}, {g}, {b})")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn progress_is_shown_in_minutes_and_seconds() {
        let seconds = Duration::from_secs;
        let text = progress(0.25, seconds(61), Some(seconds(183)));
        assert_eq!(text, " 25 %  1:01 elapsed, 3:03 to go");
        let text = progress(0.0, seconds(0), None);
        assert_eq!(text, "  0 %  0:00 elapsed, ? to go");
    }
}
