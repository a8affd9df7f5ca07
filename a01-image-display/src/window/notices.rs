//! Notices and errors, in boxes over the picture, which keeps its place and its size.

use std::time::{Duration, Instant};

use program::Gallery;

use super::area::Area;
use super::screen::Screen;

/// Time until a notice disappears.
const NOTICE: Duration = Duration::from_secs(6);

/// A sentence that is shown for some seconds.
#[derive(Clone, Debug)]
pub struct Notice {
    text: String,
    is_error: bool,
    since: Instant,
}

impl Notice {
    pub fn new(text: String, is_error: bool) -> Self {
        Self {
            text,
            is_error,
            since: Instant::now(),
        }
    }

    /// The time until it disappears.
    pub fn ends_in(&self) -> Duration {
        NOTICE.saturating_sub(self.since.elapsed())
    }
}

/// A text over the picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Message {
    pub text: String,
    pub is_error: bool,
}

impl Screen {
    /// The texts over the picture: what is wrong with it, the notice, and the path that is typed.
    pub fn messages(&self, gallery: &Gallery) -> Vec<Message> {
        let mut messages = Vec::new();
        if let Some(error) = gallery.error() {
            messages.push(Message {
                text: format!("error: {error}"),
                is_error: true,
            });
        }
        if let Some(notice) = &self.notice {
            messages.push(Message {
                text: notice.text.clone(),
                is_error: notice.is_error,
            });
        }
        if let Some(entry) = &self.path_entry {
            messages.push(Message {
                text: entry.prompt(),
                is_error: false,
            });
        }
        messages
    }

    /// Draws the texts above the lower edge of the picture's area, the last one lowest.
    pub fn draw_messages(&mut self, gallery: &Gallery) {
        let (margin, line) = (self.ui.px(10.0), self.ui.px(20.0));
        let area = self.placement.area;
        let mut bottom = area.y + area.height - self.ui.px(8.0);
        let messages = self.messages(gallery);
        for message in messages.iter().rev() {
            let width = area.width - 4 * margin;
            let lines = self.ui.letters.wrap(&message.text, width);
            let widths = lines.iter().map(|line| self.ui.letters.width(line));
            let used = widths.max().unwrap_or(0);
            let height = line * lines.len() as i32 + margin;
            let top = bottom - height;
            let around = Area::new(area.x + margin, top, used + 2 * margin, height);
            let colors = self.ui.colors;
            let (edge, color) = if message.is_error {
                (colors.error, colors.error)
            } else {
                (colors.accent, colors.text)
            };
            self.ui.frame.fill(around, edge);
            let border = self.ui.px(1.0).max(1);
            self.ui.frame.fill(around.inset(border, border), colors.bar);
            let mut at = Area::new(around.x + margin, top + margin / 2, used, line);
            for text in lines {
                self.ui.write(at, color, &text, "");
                at.y += line;
            }
            bottom = top - self.ui.px(6.0);
        }
    }
}
