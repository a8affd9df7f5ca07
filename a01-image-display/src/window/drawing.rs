//! Draws the content of the window: the picture, the lines below it, the menu above.

use std::mem;
use std::time::Duration;

use program::LivePicture;

use super::command;
use super::frame::{Area, LETTER, LINE};
use super::menu_bar::{self, PLATFORM_HAS_MENU};
use super::placement::Placement;
use super::screen::Screen;
use super::text;

const BACKGROUND: u32 = 0x18_1818;
const STRIP: u32 = 0x2B_2B2B;
const DONE: u32 = 0x3D_5A80;
const TEXT: u32 = 0xE0_E0E0;

/// The visible state of the window. If it changes, the window is drawn again.
#[derive(Debug, PartialEq)]
pub struct Look {
    title: String,
    pub window: (usize, usize),
    placement: Placement,
    menu: Option<usize>,
    /// Finished rows of a picture that is being rendered.
    rows: Option<u32>,
    /// The texts below the picture.
    texts: Vec<String>,
    /// The part of the last text's background that shows finished work, from 0 to 1.
    done: f64,
}

impl Screen {
    /// The placement of the picture at the current size of the window.
    pub fn placement(&self) -> Placement {
        let (width, height) = self.window.get_size();
        let height = (height as i32 - menu_bar::HEIGHT).max(1);
        let area = Area::new(0, menu_bar::HEIGHT, width as i32, height);
        Placement::new(self.size, area, self.zoom)
    }

    /// The current look, with the picture that is being rendered, if there is one.
    pub fn look(&self, live: Option<&LivePicture>) -> Look {
        let placement = self.placement();
        let mut texts = Vec::new();
        if self.helps {
            texts.push(command::HELP.to_owned());
        }
        if self.inspects {
            let cursor = self.input.cursor;
            let at = cursor.and_then(|(x, y)| placement.pixel(x, y));
            texts.push(inspect(at, at.and_then(|at| self.color(live, at))));
        }
        if let Some(Err(error)) = &self.outcome {
            texts.push(error.clone());
        }
        texts.extend(self.notice().map(str::to_owned));
        texts.extend(live.map(|live| progress(live.share(), live.elapsed(), live.remaining())));
        Look {
            title: self.title.clone(),
            window: self.window.get_size(),
            placement,
            menu: self.menu.selected(),
            rows: live.map(LivePicture::rows),
            texts,
            done: live.map_or(0.0, LivePicture::share),
        }
    }

    /// The colour of the picture at this column and row.
    fn color(&self, live: Option<&LivePicture>, (column, row): (u32, u32)) -> Option<u32> {
        let index = (row * self.size.width() + column) as usize;
        match live {
            Some(live) => live.pixel(index),
            None => self.pixels.get(index).copied(),
        }
    }

    /// Draws picture, texts and menu into the frame.
    pub fn draw(&mut self, live: Option<&LivePicture>, look: &Look) {
        let mut frame = mem::take(&mut self.frame);
        frame.clear(look.window, BACKGROUND);
        let area = look.placement.area();
        frame.paint(area, |x, y| {
            let at = look.placement.pixel(x, y)?;
            self.color(live, at)
        });
        let shown = frame.pixels().get((area.y * area.width) as usize..);
        self.log.set_picture(shown.filter(|_| live.is_none()));

        let columns = (area.width / LETTER - 2).max(1) as usize;
        let (mut y, mut done) = (area.y + area.height, f64::from(area.width) * look.done);
        for text in look.texts.iter().rev() {
            for line in text::wrap(text, columns).into_iter().rev() {
                y -= LINE;
                frame.fill(Area::line(y, area.width), STRIP);
                frame.fill(Area::line(y, done as i32), DONE);
                frame.text(LETTER, y + 5, TEXT, line);
            }
            done = 0.0;
        }
        if !PLATFORM_HAS_MENU {
            self.menu.draw(&mut frame, area.width, &look.title);
        }
        self.frame = frame;
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
