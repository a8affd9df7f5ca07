//! `Ui`: the items beside the picture, in immediate mode: each call adds an item, and returns
//! whether a person has used it, by its key, by the mouse, or by the arrow keys and Enter.

use program::Slider;

use super::area::Area;
use super::letters::Letters;
use super::mouse::Mouse;

/// The kind of an item, which decides how it is drawn.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// The background of the items that follow.
    Bar,
    Text,
    Muted,
    /// The name of a page, and whether that is open.
    Tab(bool),
    /// An entry of a menu, with a dot if it is chosen.
    Entry(bool),
    /// The share of the values before the knob.
    Slider(f64),
    /// A line whose first share is done.
    Progress(f64),
    Color(u32),
}

/// A part of the window, with a text at its left edge and a value at its right edge.
#[derive(Debug)]
pub struct Item {
    pub area: Area,
    pub kind: Kind,
    pub is_selected: bool,
    pub text: String,
    pub value: String,
}

/// The items, and the input for them.
#[derive(Default)]
pub struct Ui {
    pub letters: Letters,
    pub scale: f64,
    /// The pressed key, such as `S` or `Ctrl +`; empty if there is none.
    pub key: String,
    pub mouse: Mouse,
    /// The mouse at the last input.
    pub before: Mouse,
    /// From the lowest to the topmost.
    pub items: Vec<Item>,
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
    /// Whether the mouse holds the selected slider.
    is_held: bool,
    /// The number of entries and sliders.
    count: usize,
    /// Way of the panel upwards, in pixels.
    pub scroll: i32,
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
        if let Some(selected) = self.selected.filter(|_| self.count > 0) {
            for (key, step) in [("Down", 1), ("Up", self.count - 1)] {
                if self.typed(key) {
                    self.selected = Some((selected + step) % self.count);
                    self.is_sought = true;
                }
            }
        }
        (self.panel, self.count) = (panel, 0);
        self.is_held &= self.mouse.left;
        self.items.clear();
        self.next = panel.inset(self.px(22.0), self.px(8.0));
        self.next.y -= self.scroll;
        self.add(panel, Kind::Bar, "", "");
    }

    /// Ends the panel, which scrolls no farther than its items.
    pub fn end(&mut self) {
        let below = self.next.y + self.scroll - self.panel.y - self.panel.height;
        self.scroll = self.scroll.min(below).max(0);
    }

    /// Leaves the selected entry or slider; false if there is none.
    pub fn leave(&mut self) -> bool {
        let selected = self.selected.take();
        selected.is_some_and(|selected| selected < self.count)
    }

    /// Adds an item anywhere.
    pub fn add(&mut self, area: Area, kind: Kind, text: &str, value: &str) {
        self.items.push(Item {
            area,
            kind,
            text: text.to_owned(),
            value: value.to_owned(),
            is_selected: false,
        });
    }

    /// Adds an item to the panel.
    fn push(&mut self, height: f64, kind: Kind, text: &str, value: &str) -> Area {
        let height = self.px(height);
        let area = Area {
            height,
            ..self.next
        };
        self.next.y += height;
        self.add(area, kind, text, value);
        area
    }

    /// Adds a text to the panel, on as many lines as it needs.
    pub fn text(&mut self, level: usize, kind: Kind, text: &str) {
        let (left, indent) = (self.next, self.px(10.0) * level as i32);
        self.next = Area::new(left.x + indent, left.y, left.width - indent, 0);
        for line in self.letters.wrap(text, self.next.width) {
            self.push(19.0, kind, &line, "");
        }
        (self.next.x, self.next.width) = (left.x, left.width);
    }

    /// Adds a line of text and value to the panel.
    pub fn line(&mut self, kind: Kind, text: &str, value: &str) {
        self.push(24.0, kind, text, value);
    }

    /// Leaves a gap in the panel.
    pub fn gap(&mut self) {
        self.next.y += self.px(8.0);
    }

    /// Adds an entry or a slider, which a click selects: its area, whether it is selected, and
    /// whether it is clicked.
    fn select(&mut self, height: f64, kind: Kind, text: &str, value: &str) -> (Area, bool, bool) {
        let area = self.push(height, kind, text, value);
        let is_clicked = self.panel.contains(self.mouse.at) && self.clicked(area);
        if is_clicked {
            self.selected = Some(self.count);
        }
        let is_selected = self.selected == Some(self.count);
        self.count += 1;
        if is_selected && std::mem::take(&mut self.is_sought) {
            let way = area.middle()[1] - self.panel.middle()[1];
            self.scroll = (self.scroll + way as i32).max(0);
        }
        if let Some(item) = self.items.last_mut() {
            item.is_selected = is_selected;
        }
        (area, is_selected, is_clicked)
    }

    /// Adds an entry, with a dot if it is chosen. True if it is used.
    pub fn choice(&mut self, text: &str, key: &str, is_chosen: bool) -> bool {
        let is_typed = !key.is_empty() && self.typed(key);
        if !self.is_shown {
            return is_typed;
        }
        let (_, is_selected, is_clicked) = self.select(24.0, Kind::Entry(is_chosen), text, key);
        is_typed || is_clicked || is_selected && self.typed("Enter")
    }

    /// Adds an entry. True if it is used.
    pub fn entry(&mut self, text: &str, key: &str) -> bool {
        self.choice(text, key, false)
    }

    /// Adds a slider, and returns the number of the value to which it is moved.
    pub fn slider(&mut self, slider: &Slider) -> Option<usize> {
        let share = |at| at as f64 / slider.last().max(1) as f64;
        let kind = Kind::Slider(share(slider.at));
        let (area, is_selected, is_clicked) = self.select(40.0, kind, &slider.name, &slider.text());
        self.is_held |= is_clicked;
        if !is_selected {
            None
        } else if self.is_held {
            let way = f64::from(self.mouse.at[0] - area.x) / f64::from(area.width.max(1));
            Some((way.clamp(0.0, 1.0) * slider.last() as f64).round() as usize)
        } else if self.typed("Left") {
            Some(slider.at.saturating_sub(1))
        } else {
            self.typed("Right").then_some(slider.at + 1)
        }
    }
}
