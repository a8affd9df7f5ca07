//! `Letters`: draws smooth text of any size.

use std::collections::HashMap;
use std::sync::LazyLock;

use fontdue::{Font, FontSettings, Metrics};

use super::area::Area;
use super::frame::Frame;

/// The characters of Latin-1, Greek letters, arrows and signs from Inter.
static INTER: LazyLock<Option<Font>> = LazyLock::new(|| {
    let file: &[u8] = include_bytes!("../../assets/inter.otf");
    Font::from_bytes(file, FontSettings::default()).ok()
});

/// The letters of one size.
#[derive(Default)]
pub struct Letters {
    size: f32,
    known: HashMap<char, (Metrics, Vec<u8>)>,
}

impl Letters {
    /// Capitals become about 0.7 times `size` pixels high.
    pub fn resize(&mut self, size: f64) {
        self.size = size as f32;
        self.known.clear();
    }

    fn advance(&self, text: &str) -> f32 {
        let Some(font) = &*INTER else { return 0.0 };
        let advance = |letter| font.metrics(letter, self.size).advance_width;
        text.chars().map(advance).sum()
    }

    /// The width of a text in pixels.
    pub fn width(&self, text: &str) -> i32 {
        self.advance(text).ceil() as i32
    }

    /// Writes a text in the middle of the height of an area, from its left edge.
    pub fn write(&mut self, frame: &mut Frame, area: Area, color: u32, text: &str) {
        let Some(font) = &*INTER else { return };
        let base = area.y + area.height / 2 + (0.36 * self.size) as i32;
        let mut x = area.x as f32;
        for letter in text.chars() {
            let known = self.known.entry(letter);
            let (metrics, fractions) = known.or_insert_with(|| font.rasterize(letter, self.size));
            let (width, height) = (metrics.width as i32, metrics.height as i32);
            let (left, top) = (x as i32 + metrics.xmin, base - metrics.ymin - height);
            let fraction =
                |x, y| f64::from(fractions[((y - top) * width + x - left) as usize]) / 255.0;
            frame.blend(Area::new(left, top, width, height), color, fraction);
            x += metrics.advance_width;
        }
    }

    /// The lines of a text, none wider than this, broken at spaces if there are some.
    pub fn wrap(&self, text: &str, width: i32) -> Vec<String> {
        let (mut lines, mut line, mut used) = (Vec::new(), String::new(), 0.0);
        for word in text.split_inclusive(' ') {
            let mut needed = self.advance(word.trim_end());
            for letter in word.split_inclusive(|_| true) {
                let advance = self.advance(letter);
                // A word that is wider than a line is broken anywhere.
                if letter != " " && used > 0.0 && used + needed.max(advance) > width as f32 {
                    lines.push(std::mem::take(&mut line));
                    used = 0.0;
                }
                line.push_str(letter);
                used += advance;
                needed = 0.0;
            }
        }
        lines.push(line);
        lines
    }
}
