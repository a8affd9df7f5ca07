//! `Ui`: the items beside the picture, in immediate mode: each call draws an item, and returns
//! whether a person has used it, by its key, by the mouse, or by the arrow keys and Enter.

use program::Slider;

use super::appearance::Colors;
use super::area::Area;
use super::frame::Frame;
use super::mouse::Mouse;
use super::text::Letters;

/// What the mouse holds while its left button is down.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Held {
    /// The selected slider.
    Slider,
    ScrollBar,
}

/// The drawing of the items, and the input for them.
#[derive(Default)]
pub struct Ui {
    pub frame: Frame,
    pub letters: Letters,
    pub colors: Colors,
    pub scale: f64,
    /// The pressed key, such as `S` or `Ctrl +`; empty if there is none.
    pub key: String,
    pub mouse: Mouse,
    /// The mouse at the last input.
    pub before: Mouse,
    /// The written texts, with their places; only tests need them.
    pub words: Vec<String>,
    /// The part of the window for entries and sliders, which may be empty.
    pub panel: Area,
    /// The place for the next item of the panel.
    next: Area,
    /// Whether entries are shown; the keys of hidden ones work, too.
    pub is_shown: bool,
    /// Number of the entry or slider that the arrow keys control.
    pub selected: Option<usize>,
    /// Whether the selected item has to come into view.
    pub is_sought: bool,
    /// What the mouse holds.
    held: Option<Held>,
    /// The number of entries and sliders.
    count: usize,
    /// Displacement of the panel's items upwards, in pixels.
    pub scroll: i32,
    /// The largest displacement, at which the last item is at the lower edge.
    most_scroll: i32,
}

impl Ui {
    pub fn set_scale(&mut self, scale: f64) {
        self.scale = scale.clamp(0.5, 4.0);
        self.letters.resize(13.0 * self.scale);
    }

    /// A length in pixels from one at scale 1.
    pub fn px(&self, length: f64) -> i32 {
        (length * self.scale).round() as i32
    }

    /// Whether this key has been pressed, and had no effect yet.
    pub fn typed(&mut self, key: &str) -> bool {
        let is_typed = self.key == key;
        if is_typed {
            self.key.clear();
        }
        is_typed
    }

    /// Whether the left button has been pressed inside of an area, and had no effect yet.
    pub fn clicked(&mut self, area: Area) -> bool {
        let is_clicked = self.mouse.left && !self.before.left && area.contains(self.mouse.at);
        self.before.left |= is_clicked;
        is_clicked
    }

    /// Begins a list of items, with a panel whose first items stand below its upper edge.
    pub fn begin(&mut self, panel: Area) {
        if self.count > 0 {
            let count = self.count;
            let next = self.selected.map_or(0, |at| (at + 1) % count);
            let before = self
                .selected
                .map_or(count - 1, |at| (at + count - 1) % count);
            let is_selected = self.selected.is_some();
            for (key, to) in [("Tab", next), ("Shift Tab", before)] {
                if self.typed(key) {
                    (self.selected, self.is_sought) = (Some(to), true);
                }
            }
            for (key, to) in [("Down", next), ("Up", before)] {
                if is_selected && self.typed(key) {
                    (self.selected, self.is_sought) = (Some(to), true);
                }
            }
        }
        (self.panel, self.count) = (panel, 0);
        self.held.take_if(|_| !self.mouse.left);
        self.words.clear();
        self.next = panel.inset(self.px(22.0), self.px(8.0));
        self.next.y -= self.scroll;
        self.frame.fill(panel, self.colors.bar);
    }

    /// Ends the panel, which scrolls no farther than its items, and draws a scroll bar if it has
    /// more of them than it shows.
    pub fn end(&mut self) {
        let panel = self.panel;
        let height = self.next.y + self.scroll - panel.y + self.px(8.0);
        let hidden = (height - panel.height).max(0);
        self.most_scroll = hidden;
        self.scroll_by(0);
        if hidden == 0 || panel.width == 0 {
            return;
        }
        let track = Area {
            x: panel.x + panel.width - self.px(10.0),
            width: self.px(10.0),
            ..panel
        };
        let fraction = f64::from(panel.height) / f64::from(height);
        let least = self.px(24.0).min(panel.height);
        let length = ((f64::from(panel.height) * fraction) as i32).max(least);
        let way = (panel.height - length).max(1);
        if self.clicked(track) {
            self.held = Some(Held::ScrollBar);
        }
        let is_held = self.held == Some(Held::ScrollBar);
        if is_held {
            // The middle of the thumb follows the mouse.
            let at = f64::from(self.mouse.at[1] - panel.y - length / 2) / f64::from(way);
            self.scroll = (at.clamp(0.0, 1.0) * f64::from(hidden)).round() as i32;
        }
        let at = f64::from(self.scroll) / f64::from(hidden) * f64::from(way);
        let thumb = Area::new(track.x, panel.y + at as i32, track.width, length);
        self.frame.fill(track, self.colors.bar);
        let color = if is_held {
            self.colors.accent
        } else {
            self.colors.muted
        };
        let inset = self.px(3.0);
        self.frame.fill(thumb.inset(inset, inset), color);
        self.words
            .push(format!("scrolled: {} of {hidden}", self.scroll));
    }

    /// Scrolls the panel downwards, at most to its last item.
    pub fn scroll_by(&mut self, way: i32) {
        self.scroll = (self.scroll + way).clamp(0, self.most_scroll);
    }

    /// Leaves the selected entry or slider; false if there is none.
    pub fn leave(&mut self) -> bool {
        let selected = self.selected.take();
        selected.is_some_and(|selected| selected < self.count)
    }

    /// Writes a text at the left edge of an area, and a value at the right edge if it has room.
    pub fn write(&mut self, mut area: Area, color: u32, text: &str, value: &str) {
        self.words.push(format!("{text:?} {value:?} {area:?}"));
        let (frame, letters) = (&mut self.frame, &mut self.letters);
        letters.write(frame, area, color, text);
        let left = area.width - letters.width(value);
        if letters.width(text) <= left {
            area.x += left;
            letters.write(frame, area, self.colors.muted, value);
        }
    }

    /// The place of the next item of the panel.
    pub fn place(&mut self, height: f64) -> Area {
        let height = self.px(height);
        let area = Area {
            height,
            ..self.next
        };
        self.next.y += height;
        area
    }

    /// Adds a text to the panel, on as many lines as it needs.
    pub fn text(&mut self, level: usize, color: u32, text: &str) {
        self.text_area(level, color, text);
    }

    /// The width of a line of the panel, which is indented by a level.
    pub fn width_at(&self, level: usize) -> i32 {
        self.next.width - self.px(10.0) * level as i32
    }

    /// Adds a line to the panel, with a value at its right edge, and returns its area.
    pub fn line(&mut self, level: usize, color: u32, text: &str, value: &str) -> Area {
        let width = self.width_at(level);
        let mut area = self.place(19.0);
        (area.x, area.width) = (area.x + area.width - width, width);
        self.write(area, color, text, value);
        area
    }

    /// Adds a text to the panel, and returns its area.
    pub fn text_area(&mut self, level: usize, color: u32, text: &str) -> Area {
        let indent = self.px(10.0) * level as i32;
        let mut whole = self.place(0.0);
        for line in self.letters.wrap(text, self.next.width - indent) {
            let mut area = self.place(19.0);
            whole.height += area.height;
            area.x += indent;
            self.write(area, color, &line, "");
        }
        whole
    }

    /// Adds a heading to the panel, below a line.
    pub fn heading(&mut self, text: &str) {
        let rule = self.place(9.0);
        let y = rule.y + rule.height / 2;
        let line = Area::new(rule.x, y, rule.width, self.px(1.0).max(1));
        self.frame.fill(line, self.colors.raised);
        self.text(0, self.colors.accent, text);
    }

    /// Whether the left button has been pressed inside of an area of the panel.
    pub fn clicked_in_panel(&mut self, area: Area) -> bool {
        self.panel.contains(self.mouse.at) && self.clicked(area)
    }

    /// Marks an area, which stands for a chosen item.
    pub fn mark(&mut self, area: Area) {
        let area = area.inset(self.px(-8.0), self.px(1.0));
        self.frame.fill(area, self.colors.raised);
    }

    /// Adds a place for an entry or a slider, which a click selects: its area, whether it is
    /// selected, and whether it is clicked.
    fn select(&mut self, height: f64) -> (Area, bool, bool) {
        let area = self.place(height);
        let is_clicked = self.clicked_in_panel(area);
        if is_clicked {
            self.selected = Some(self.count);
        }
        let is_selected = self.selected == Some(self.count);
        self.count += 1;
        if is_selected && std::mem::take(&mut self.is_sought) {
            let way = area.middle()[1] - self.panel.middle()[1];
            self.scroll = (self.scroll + way as i32).max(0);
        }
        if is_selected {
            self.mark(area);
            self.words.push("selected:".to_owned());
        }
        (area, is_selected, is_clicked)
    }

    /// Adds an entry, with a dot if it is chosen. True if it is used.
    pub fn choice(&mut self, text: &str, key: &str, is_chosen: bool) -> bool {
        let is_typed = !key.is_empty() && self.typed(key);
        if !self.is_shown {
            return is_typed;
        }
        let (area, is_selected, is_clicked) = self.select(24.0);
        if is_chosen {
            let dot = [f64::from(area.x - self.px(10.0)), area.middle()[1]];
            let width = 6.0 * self.scale;
            self.frame.line([dot; 2], width, self.colors.accent, 1.0);
        }
        self.write(area, self.colors.text, text, key);
        is_typed || is_clicked || is_selected && self.typed("Enter")
    }

    /// Adds an entry. True if it is used.
    pub fn entry(&mut self, text: &str, key: &str) -> bool {
        self.choice(text, key, false)
    }

    /// Adds a slider, and returns the number of the value to which it is moved.
    pub fn slider(&mut self, slider: &Slider) -> Option<usize> {
        let (mut area, is_selected, is_clicked) = self.select(40.0);
        let [left, width] = [area.x, area.width].map(f64::from);
        let fraction = slider.at as f64 / slider.last().max(1) as f64;
        let y = area.middle()[1] + 11.0 * self.scale;
        let end = |fraction: f64| [left + width * fraction, y];
        for (from, to, width, color, opacity) in [
            (0.0, 1.0, 3.0, self.colors.muted, 0.5),
            (0.0, fraction, 3.0, self.colors.accent, 1.0),
            (fraction, fraction, 12.0, self.colors.accent, 1.0),
        ] {
            let ends = [end(from), end(to)];
            self.frame.line(ends, width * self.scale, color, opacity);
        }
        area.height = self.px(24.0);
        self.write(area, self.colors.text, &slider.name, &slider.text());
        if is_clicked {
            self.held = Some(Held::Slider);
        }
        if !is_selected {
            None
        } else if self.held == Some(Held::Slider) {
            let fraction = (f64::from(self.mouse.at[0]) - left) / width.max(1.0);
            Some((fraction.clamp(0.0, 1.0) * slider.last() as f64).round() as usize)
        } else if self.typed("Left") {
            Some(slider.at.saturating_sub(1))
        } else {
            self.typed("Right").then_some(slider.at + 1)
        }
    }
}
