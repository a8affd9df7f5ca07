//! `Screen`: where the menu, the picture and the lines below it stand in the window, and how they are
//! drawn.

use common::Size;
use minifb::Key;
use program::{ExplainedPixel, Gallery, LivePicture};

use super::frame::{Area, Frame, wrapped};

const BACKGROUND: u32 = 0x14_161A;
const BAR: u32 = 0x22_262D;
const TEXT: u32 = 0xE8_E6E1;
const ACCENT: u32 = 0xFF_B454;

/// The height of a line, in dots.
const LINE: i32 = 22;

/// The least number of lines below the picture.
const LINES: usize = 3;

/// All keys, and what they do.
const KEYS: [(&str, &str); 10] = [
    ("S", "save the picture"),
    ("O", "open a picture, in stage 1"),
    ("left, right", "another scene"),
    ("click, E", "the numbers behind a pixel"),
    ("wheel", "camera nearer, farther"),
    ("right drag", "rotate the camera"),
    ("R", "camera back"),
    ("C", "print the camera in the terminal"),
    ("H", "this list"),
    ("Esc", "close"),
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
    /// Width and height of the picture.
    sides: [u32; 2],
    /// Pixels of the window for a pixel of the picture.
    scale: f64,
    /// The upper left corner of the picture.
    corner: [i32; 2],
    /// The entries of the menu with their keys.
    menu: Vec<(Area, Key)>,
}

/// The size in which the window opens: the picture's, in whole multiples if that is small, or shrunk
/// where a side is too long for nearly every screen, with room for menu and text. minifb does not know the size of
/// this screen.
pub fn window_size(picture: Size) -> (usize, usize) {
    let [width, height] = [picture.width(), picture.height()].map(f64::from);
    let shrunk = (1280.0 / width).min(600.0 / height).min(1.0);
    let enlarged = (480.0 / width).min(240.0 / height).floor().max(1.0);
    let scale = if shrunk < 1.0 { shrunk } else { enlarged };
    let width = (width * scale).round().max(480.0) as i32;
    let height = (height * scale).round() as i32;
    let bars = menu_height(dot(width)) + text_height(dot(width), LINES);
    (width as usize, (height + bars) as usize)
}

/// The width of a dot: a line of the window has room for 60 letters or more.
const fn dot(width: i32) -> i32 {
    1 + width / 960
}

const fn menu_height(dot: i32) -> i32 {
    30 * dot
}

const fn text_height(dot: i32, lines: usize) -> i32 {
    LINE * dot * lines as i32 + 12 * dot
}

impl Screen {
    /// Places a picture in a window: as large as fits, where that is larger than the picture by a whole
    /// factor, so that each pixel is a square. True if it was not there.
    pub fn place(&mut self, window: (usize, usize), picture: Size) -> bool {
        let sides = [picture.width(), picture.height()];
        if (self.size, self.sides) == (window, sides) {
            return false;
        }
        (self.size, self.sides) = (window, sides);
        let [width, height] = [window.0, window.1].map(|side| side as i32);
        self.dot = dot(width);
        let top = menu_height(self.dot);
        let room = [width, height - top - text_height(self.dot, LINES)];
        let fit = |axis: usize| f64::from(room[axis].max(1)) / f64::from(sides[axis]);
        let scale = fit(0).min(fit(1));
        self.scale = if scale > 1.0 { scale.floor() } else { scale };
        let start = |axis: usize| {
            let shown = self.scale * f64::from(sides[axis]);
            (f64::from(room[axis]) - shown) as i32 / 2
        };
        self.corner = [start(0), top + start(1)];
        true
    }

    /// Column and row of the picture's pixel at a place of the window.
    pub fn pixel_at(&self, at: [i32; 2]) -> Option<[u32; 2]> {
        let place = |axis: usize| {
            let way = f64::from(at[axis] - self.corner[axis]) + 0.5;
            let inside = (way / self.scale).floor();
            (0.0..f64::from(self.sides[axis]))
                .contains(&inside)
                .then_some(inside as u32)
        };
        Some([place(0)?, place(1)?])
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

    /// Draws the picture, of which a pixel of the window shows one pixel; where it is shrunk, the
    /// mean of four.
    fn draw_picture(&mut self, picture: &LivePicture) {
        let sides = self.sides;
        let (scale, corner) = (self.scale, self.corner);
        let end = |axis: usize| (scale * f64::from(sides[axis])).ceil() as i32;
        let area = Area {
            x: corner[0],
            y: corner[1],
            width: end(0),
            height: end(1),
        };
        // The pixel at a place that is so many quarters of a pixel from the edge of another one.
        let pixel = |axis: usize, at: i32, quarters: f64| {
            let place = (f64::from(at - corner[axis]) + quarters / 4.0) / scale;
            (place as u32).min(sides[axis] - 1)
        };
        for ([left, y], row) in self.frame.rows(area) {
            let rows = [1.0, 2.0, 3.0].map(|quarters| pixel(1, y, quarters));
            for (x, shown) in (left..).zip(row) {
                if scale >= 1.0 {
                    *shown = picture.pixel(pixel(0, x, 2.0), rows[1]);
                    continue;
                }
                let columns = [1.0, 3.0].map(|quarters| pixel(0, x, quarters));
                let four = [rows[0], rows[2]].map(|y| columns.map(|x| picture.pixel(x, y)));
                *shown = mean(four.as_flattened());
            }
        }
    }

    /// Draws the rays of a pixel over the picture, with gaps where an object hides them.
    fn draw_rays(&mut self, explained: &ExplainedPixel) {
        let (scale, corner) = (self.scale, self.corner);
        let place =
            |point: [f64; 2]| [0, 1].map(|axis| f64::from(corner[axis]) + scale * point[axis]);
        let dot = f64::from(self.dot);
        for (width, color) in [(4.0, 0), (2.0, ACCENT)] {
            for (number, ray) in explained.rays.iter().enumerate() {
                let ends = ray.ends.map(place);
                let is_gap = ray.is_hidden && number % 2 == 1;
                // A ray may lead far out of the picture.
                if !is_gap && ends.iter().any(|end| self.shows(*end)) {
                    self.frame.line(ends, width * dot, color);
                }
            }
        }
        let middle = place(explained.pixel.map(|at| f64::from(at) + 0.5));
        for (width, color) in [(9.0, 0), (7.0, 0xFF_FFFF), (4.0, ACCENT)] {
            self.frame.line([middle; 2], width * dot, color);
        }
    }

    /// Whether a point lies in the window.
    fn shows(&self, point: [f64; 2]) -> bool {
        let sides = [self.size.0, self.size.1];
        [0, 1]
            .iter()
            .all(|axis| (0.0..sides[*axis] as f64).contains(&point[*axis]))
    }

    /// Draws the lines of text below the picture, and between both the progress.
    fn draw_text(&mut self, gallery: &Gallery, pointer: [i32; 2]) {
        let dot = self.dot;
        let (width, height) = (self.size.0 as i32, self.size.1 as i32);
        let letters = (width - 20 * dot) / (8 * dot);
        let mut lines = Vec::new();
        for line in gallery.lines(self.pixel_at(pointer)) {
            lines.extend(wrapped(&line, letters as usize));
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
        for line in lines {
            self.frame.text([10 * dot, y], dot, TEXT, &line);
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

    /// The area for the picture is 640 x 480 pixels, from (0, 30) on.
    #[test]
    fn a_picture_fits_by_a_whole_factor_or_is_shrunk() {
        for (side, scale, corner, last, first) in [
            (480, 1.0, [80, 30], [559, 509], 0),
            (200, 2.0, [120, 70], [519, 469], 0),
            // The middle of a pixel of the window is where four of the picture meet.
            (960, 0.5, [80, 30], [559, 509], 1),
        ] {
            let mut screen = Screen::default();
            let window = (640, (30 + 480 + text_height(1, LINES)) as usize);
            let size = Size::new(side, side).unwrap();
            assert!(screen.place(window, size) && !screen.place(window, size));
            assert_eq!((screen.scale, screen.corner), (scale, corner));
            assert_eq!(screen.pixel_at(corner), Some([first; 2]));
            assert_eq!(screen.pixel_at(last), Some([side - 1; 2]));
            assert_eq!(screen.pixel_at(last.map(|at| at + 1)), None);
            assert_eq!(screen.pixel_at(corner.map(|at| at - 1)), None);
        }
    }

    #[test]
    fn the_window_has_room_for_the_picture_and_no_more_than_a_screen() {
        let room = |width, height| {
            let (width, height) = window_size(Size::new(width, height).unwrap());
            (width, height - 30 - text_height(1, LINES) as usize)
        };
        assert_eq!(room(640, 480), (640, 480));
        assert_eq!(room(64, 48), (480, 240));
        let (width, height) = window_size(Size::new(8192, 8192).unwrap());
        assert!(width <= 1280 && height <= 720, "{width}x{height}");
    }

    #[test]
    fn the_mean_of_four_colours_is_that_of_each_channel() {
        let four = [0xFF_FF00, 0xFF_0000, 0x00_0002, 0xFE_0102];
        assert_eq!(mean(&four), 0xBF_4001);
    }
}
