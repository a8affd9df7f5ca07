//! `Screen`: where the menu, the picture and the lines below it stand in the window, and how they are
//! drawn.

use std::mem;

use command_line::{ExplainedPixel, Gallery, LivePicture};
use common::{Renderer, Size};
use minifb::Key;

use super::frame::{Area, Frame, wrapped};
use super::placement::Placement;

const BACKGROUND: u32 = 0x14_161A;
const BAR: u32 = 0x22_262D;
const TEXT: u32 = 0xE8_E6E1;
const ACCENT: u32 = 0xFF_B454;
const MISTAKE: u32 = 0xFF_7B72;

/// The height of a line, in dots.
const LINE: i32 = 22;

/// The least number of lines below the picture.
const LINES: usize = 3;

/// All keys, and what they do.
const KEYS: [(&str, &str); 12] = [
    ("S", "save the picture"),
    ("O", "open a picture, in stage 1"),
    ("left, right", "another scene"),
    ("click, E", "the numbers behind a pixel"),
    ("wheel", "camera nearer, farther"),
    ("right drag", "rotate the camera"),
    ("R", "camera back"),
    ("C", "print the camera in the terminal"),
    ("F", "the fast renderer, or the lesson"),
    ("H", "this list"),
    ("Esc", "close"),
    ("menu", "the same, on any keyboard"),
];

/// What the window shows.
#[derive(Default)]
pub struct Screen {
    /// Width and height of the window.
    size: (usize, usize),
    pub frame: Frame,
    /// Whether all keys are listed over the picture.
    pub lists_keys: bool,
    /// The side of a dot of the letters, in pixels.
    dot: i32,
    /// Where the picture stands.
    pub placement: Placement,
    /// The entries of the menu with their keys.
    menu: Vec<(Area, Key)>,
}

/// The size in which the window opens: that of the picture, enlarged by a whole factor if that is small on the
/// screen, or shrunk to less than it, with room for menu and text. A screen of 0 is unknown: then the window fits
/// nearly every one.
pub fn window_size(picture: Size, screen: [u16; 2]) -> (usize, usize) {
    let [width, height] = [picture.width(), picture.height()].map(f64::from);
    let [wide, high] = screen.map(f64::from);
    // Several screens beside or above each other may be told as one.
    let high = high.min(0.6 * wide);
    let room = 0.92 * high - f64::from(bars(dot((1.6 * high) as i32)));
    let most = ((1.6 * high).max(1280.0) / width).min(room.max(600.0) / height);
    let enlarged = (0.8 * high).max(480.0) / width;
    let enlarged = enlarged.min((0.5 * high).max(240.0) / height).floor();
    let scale = most.min(enlarged.max(1.0));
    let width = (width * scale).max(480.0) as i32;
    let bars = bars(dot(width)) as usize;
    (width as usize, (height * scale) as usize + bars)
}

/// The width of a dot of the letters, in a window of this width.
const fn dot(width: i32) -> i32 {
    1 + width / 1280
}

const fn menu_height(dot: i32) -> i32 {
    30 * dot
}

/// The height of menu and text.
const fn bars(dot: i32) -> i32 {
    menu_height(dot) + text_height(dot, LINES)
}

const fn text_height(dot: i32, lines: usize) -> i32 {
    LINE * dot * lines as i32 + 12 * dot
}

impl Screen {
    /// Places the picture in a window of this size. True if it was not there.
    pub fn place(&mut self, window: (usize, usize), picture: Size) -> bool {
        self.size = window;
        let [width, height] = [window.0, window.1].map(|side| side as i32);
        self.dot = dot(width);
        let top = menu_height(self.dot);
        let room = Area {
            x: 0,
            y: top,
            width,
            height: height - top - text_height(self.dot, LINES),
        };
        let placement = Placement::new(picture, room);
        mem::replace(&mut self.placement, placement) != placement
    }

    /// The key of the menu's entry at a place of the window.
    pub fn key_at(&self, at: [i32; 2]) -> Option<Key> {
        let mut entries = self.menu.iter();
        let entry = entries.find(|(area, _)| area.contains(at));
        entry.map(|(_, key)| *key)
    }

    /// Draws the window.
    pub fn draw(&mut self, gallery: &Gallery, pointer: [i32; 2]) {
        self.frame = Frame::new(self.size.0, self.size.1, BACKGROUND);
        self.draw_picture(gallery.picture());
        if let Some(explained) = gallery.explained() {
            self.draw_rays(explained);
        }
        self.draw_text(gallery, pointer);
        self.draw_menu(gallery, pointer);
        if self.lists_keys {
            self.draw_keys();
        }
    }

    /// Draws the picture. A pixel of the window shows the mean of four places in it, so that all pixels of an
    /// enlarged picture look equally wide, and no line of a shrunk one is lost.
    fn draw_picture(&mut self, picture: &LivePicture) {
        let placement = self.placement;
        let quarters = |axis, at| [0.25, 0.75].map(|part| placement.inside(axis, at, part));
        for ([left, y], row) in self.frame.rows(placement.area()) {
            let rows = quarters(1, y);
            for (x, shown) in (left..).zip(row) {
                let columns = quarters(0, x);
                *shown = if rows[0] == rows[1] && columns[0] == columns[1] {
                    picture.pixel(columns[0], rows[0])
                } else {
                    let four = rows.map(|y| columns.map(|x| picture.pixel(x, y)));
                    mean(four.as_flattened())
                };
            }
        }
    }

    /// Draws the rays of a pixel over the picture, with gaps where an object hides them.
    fn draw_rays(&mut self, explained: &ExplainedPixel) {
        let placement = self.placement;
        let dot = f64::from(self.dot);
        for (width, color) in [(4.0, 0), (2.0, ACCENT)] {
            for (number, ray) in explained.rays.iter().enumerate() {
                let is_gap = ray.is_hidden && number % 2 == 1;
                if !is_gap {
                    let ends = ray.ends.map(|end| placement.in_window(end));
                    self.frame.line(ends, width * dot, color);
                }
            }
        }
        let middle = explained.pixel.map(|at| f64::from(at) + 0.5);
        let middle = placement.in_window(middle);
        for (width, color) in [(9.0, 0), (7.0, 0xFF_FFFF), (4.0, ACCENT)] {
            self.frame.line([middle; 2], width * dot, color);
        }
    }

    /// Draws the lines of text below the picture, and between both the progress.
    fn draw_text(&mut self, gallery: &Gallery, pointer: [i32; 2]) {
        let dot = self.dot;
        let (width, height) = (self.size.0 as i32, self.size.1 as i32);
        let letters = (width - 20 * dot) / (8 * dot);
        let mut lines = Vec::new();
        if let Some(line) = gallery.mistake() {
            let wrapped = wrapped(&line, letters as usize);
            lines.extend(wrapped.into_iter().map(|line| (MISTAKE, line)));
        }
        for line in gallery.lines(self.placement.pixel_at(pointer)) {
            let wrapped = wrapped(&line, letters as usize);
            lines.extend(wrapped.into_iter().map(|line| (TEXT, line)));
        }
        let top = height - text_height(dot, lines.len().max(LINES));
        let bar = Area {
            x: 0,
            y: top,
            width,
            height: height - top,
        };
        self.frame.fill(bar, BAR);
        if gallery.is_rendering() {
            let done = f64::from(width) * gallery.picture().fraction().min(1.0);
            let done = Area {
                width: done as i32,
                height: dot,
                ..bar
            };
            self.frame.fill(done, ACCENT);
        }
        let mut y = top + 9 * dot;
        for (color, line) in lines {
            self.frame.text([10 * dot, y], dot, color, &line);
            y += LINE * dot;
        }
    }

    /// Draws the menu above the picture.
    fn draw_menu(&mut self, gallery: &Gallery, pointer: [i32; 2]) {
        let dot = self.dot;
        let bar = Area {
            x: 0,
            y: 0,
            width: self.size.0 as i32,
            height: menu_height(dot),
        };
        self.frame.fill(bar, BAR);
        let mut entries = vec![("S", "save", Key::S)];
        if gallery.opens_pictures() {
            entries.push(("O", "open", Key::O));
        }
        entries.extend([("R", "back", Key::R), ("C", "camera", Key::C)]);
        if let Some(other) = gallery.by_other_renderer() {
            let is_fast = other.renderer == Renderer::Engine;
            entries.push(("F", if is_fast { "fast" } else { "lesson" }, Key::F));
        }
        entries.extend([("H", "keys", Key::H), ("Esc", "close", Key::Escape)]);
        self.menu.clear();
        let mut x = 10 * dot;
        for (name, text, key) in entries {
            let start = x + 8 * dot * (name.len() as i32 + 1);
            let end = start + 8 * dot * text.len() as i32;
            let area = Area {
                x: x - 4 * dot,
                width: end - x + 8 * dot,
                ..bar
            };
            let is_below = area.contains(pointer);
            let color = if is_below { ACCENT } else { TEXT };
            self.frame.text([x, 7 * dot], dot, ACCENT, name);
            self.frame.text([start, 7 * dot], dot, color, text);
            self.menu.push((area, key));
            x = end + 16 * dot;
        }
    }

    /// Draws the list of all keys below the menu.
    fn draw_keys(&mut self) {
        let dot = self.dot;
        let area = Area {
            x: 0,
            y: menu_height(dot),
            width: 8 * dot * 50,
            height: LINE * dot * KEYS.len() as i32 + 18 * dot,
        };
        let inside = Area {
            width: area.width - dot,
            height: area.height - dot,
            ..area
        };
        self.frame.fill(area, ACCENT);
        self.frame.fill(inside, BAR);
        let mut y = area.y + 12 * dot;
        for (key, text) in KEYS {
            self.frame.text([10 * dot, y], dot, ACCENT, key);
            self.frame.text([8 * dot * 15, y], dot, TEXT, text);
            y += LINE * dot;
        }
    }
}

/// The mean of four packed colours. Red and blue have room for their sums beside each other.
fn mean(four: &[u32]) -> u32 {
    let sum = |mask: u32| (four.iter().map(|color| color & mask).sum::<u32>() / 4) & mask;
    sum(0xFF_00FF) | sum(0x00_FF00)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_window_has_room_for_the_picture_and_no_more_than_a_screen() {
        let on = |width, height, screen| window_size(Size::new(width, height).unwrap(), screen);
        let size = |width, height| on(width, height, [0; 2]);
        let bars = bars(1) as usize;
        assert_eq!(size(640, 480), (640, 480 + bars));
        assert_eq!(size(64, 48), (480, 240 + bars));
        let (width, height) = size(8192, 8192);
        assert!(width <= 1280 && height <= 720, "{width}x{height}");
        // Usual screens, one that stands, and two beside or above each other.
        for (wide, high, is_enlarged) in [
            (1366, 768, false),
            (1920, 1080, false),
            (3840, 2160, true),
            (1440, 2560, false),
            (3840, 1080, false),
            (1920, 2160, false),
        ] {
            let screen = [wide, high];
            let (width, height) = on(640, 480, screen);
            let factor = 1 + usize::from(is_enlarged);
            assert_eq!(width, 640 * factor, "{wide}x{high}");
            assert!(height > 480 * factor);
            for (width, height) in [(8192, 8192), (8192, 4608), (64, 48)] {
                let (width, height) = on(width, height, screen);
                let [wide, high] = [wide, high.min(wide / 5 * 3)].map(usize::from);
                assert!(width <= wide && height <= high, "{width}x{height}");
            }
        }
    }
}
