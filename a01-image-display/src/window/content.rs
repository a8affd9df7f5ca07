//! `Content`: the parts of the window beside the picture, as a list of items.
//!
//! The list is drawn, finds the target of the mouse, and is what the tests read.

use program::Gallery;

use super::command::{Command, HELP, MENU, Page};
use super::frame::Area;
use super::placement::Placement;
use super::screen::Screen;

/// Height of the bar and width of the panel, at scale 1.
pub const BAR: f64 = 30.0;
pub const PANEL: f64 = 300.0;

/// Most steps of a pixel that are listed.
const MOST_STEPS: usize = 300;

/// The kind of an item, which decides how it is drawn.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// The background of the items that follow.
    Bar,
    Text,
    Muted,
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
    pub text: String,
    pub value: String,
    pub command: Option<Command>,
}

/// The parts of the window.
#[derive(Debug)]
pub struct Content {
    pub placement: Placement,
    /// The part for the panel, which may be empty.
    pub panel: Area,
    /// The place for the next item of the panel.
    next: Area,
    /// From the lowest to the topmost.
    pub items: Vec<Item>,
}

impl Content {
    fn add(&mut self, area: Area, kind: Kind, text: &str, value: &str) -> &mut Item {
        let index = self.items.len();
        self.items.push(Item {
            area,
            kind,
            text: text.to_owned(),
            value: value.to_owned(),
            command: None,
        });
        &mut self.items[index]
    }

    /// Adds an item to the panel. One outside of it is no target of the mouse.
    fn push(&mut self, height: i32, kind: Kind, text: &str, value: &str) -> &mut Item {
        let area = Area {
            height,
            ..self.next
        };
        self.next.y += height;
        self.add(area, kind, text, value)
    }

    /// The topmost item at a place.
    pub fn item_at(&self, at: (i32, i32)) -> Option<&Item> {
        self.items.iter().rev().find(|item| item.area.contains(at))
    }
}

impl Screen {
    /// A length in pixels from one at scale 1.
    pub fn ui(&self, length: f64) -> i32 {
        (length * self.scale).round() as i32
    }

    /// The content of the window at its current size.
    pub fn content(&mut self, gallery: &Gallery) -> Content {
        let (width, height) = self.window.get_size();
        let (width, height, margin) = (width as i32, height as i32, self.ui(12.0));
        let error = gallery
            .outcome
            .as_ref()
            .and_then(|outcome| outcome.as_ref().err());
        let messages = error.map(|error| format!("error: {error}")).into_iter();
        let messages = messages.chain(self.notice().map(str::to_owned));
        let lines: Vec<_> = messages
            .flat_map(|text| self.letters.wrap(&text, width - 2 * margin))
            .collect();
        let (bar, line) = (self.ui(BAR), self.ui(20.0));
        let top = height - bar - line * lines.len() as i32;
        let side = self.page.map_or(0, |_| self.ui(PANEL).min(width / 2));
        let panel = Area::new(width - side, 0, side, top.max(1));
        let picture = Area::new(0, 0, (width - side).max(1), top.max(1));
        let mut content = Content {
            placement: Placement::new(gallery.size(), picture, self.zoom),
            panel,
            next: panel.inset(self.ui(22.0), 0),
            items: Vec::new(),
        };
        self.add_panel(&mut content, gallery);

        content.add(Area::new(0, top, width, height - top), Kind::Bar, "", "");
        let mut area = Area::new(margin, top, width - 2 * margin, line);
        for text in lines {
            content.add(area, Kind::Text, &text, "");
            area.y += line;
        }
        area.height = bar;
        let pixel = self.mouse.cursor.and_then(|at| content.placement.pixel(at));
        let text = match (&gallery.picture, pixel) {
            (Some(live), _) if gallery.outcome.is_none() => {
                let share = live.share().min(1.0);
                let line = Area::new(0, top, width, self.ui(3.0));
                content.add(line, Kind::Progress(share), "", "");
                progress(
                    share,
                    live.elapsed().as_secs(),
                    live.remaining().map(|t| t.as_secs()),
                )
            }
            (Some(live), Some((x, y))) => {
                let [_, r, g, b] = live.pixel(x, y).unwrap_or(0).to_be_bytes();
                format!("column {x}, row {y}: ({r}, {g}, {b})")
            }
            _ => format!("{}   H shows the menu", gallery.scene.name),
        };
        let zoom = format!("{:.0} %", 100.0 * content.placement.scale);
        content.add(area, Kind::Muted, &text, &zoom);
        content
    }

    /// Adds the page of the panel, below the names of all pages.
    fn add_panel(&mut self, content: &mut Content, gallery: &Gallery) {
        content.add(content.panel, Kind::Bar, "", "");
        let bar = self.ui(BAR);
        content.next.y = bar + self.ui(8.0) - self.scroll;
        match self.page {
            Some(Page::Menu) => self.add_menu(content, gallery),
            Some(Page::Scene) => {
                for (i, slider) in gallery.sliders.iter().enumerate() {
                    let kind = Kind::Slider(slider.at as f64 / slider.last().max(1) as f64);
                    let item = content.push(self.ui(40.0), kind, &slider.name, &slider.text());
                    item.command = Some(Command::Slider(i));
                }
            }
            Some(Page::Pixel) => self.add_pixel(content, gallery),
            None => return,
        }
        let below = content.next.y + self.scroll - content.panel.height;
        self.scroll = self.scroll.min(below).max(0);
        let area = Area {
            height: bar,
            ..content.panel
        };
        content.add(area, Kind::Bar, "", "");
        let pages = [
            ("Menu", Page::Menu),
            ("Scene", Page::Scene),
            ("Pixel", Page::Pixel),
        ];
        for (i, (name, page)) in (0..).zip(pages) {
            let width = content.panel.width / 3;
            let area = Area::new(area.x + width * i, 0, width, bar);
            let command = Some(Command::Page(page));
            content
                .add(area.inset(self.ui(22.0), 0), Kind::Text, name, "")
                .command = command;
        }
    }

    fn add_menu(&self, content: &mut Content, gallery: &Gallery) {
        let line = self.ui(24.0);
        let is_useful = |command: &Command| match command {
            Command::Open => gallery.scene.uses.file,
            Command::RenderWith(_) => gallery.scene.uses.sampling,
            _ => true,
        };
        for (text, key, command) in MENU.into_iter().filter(|(.., command)| is_useful(command)) {
            let is_chosen = command == Command::RenderWith(gallery.renderer());
            content
                .push(line, Kind::Entry(is_chosen), text, key)
                .command = Some(command);
        }
        content.next.y += self.ui(8.0);
        for (i, scene) in gallery.stage.scenes.iter().enumerate() {
            let kind = Kind::Entry(scene.name == gallery.scene.name);
            content.push(line, kind, scene.name, "").command = Some(Command::Scene(i));
        }
        content.next.y += self.ui(8.0);
        for (text, key) in HELP {
            content.push(line, Kind::Muted, text, key);
        }
    }

    /// Adds the numbers behind the pixel that is explained.
    fn add_pixel(&self, content: &mut Content, gallery: &Gallery) {
        let left = content.next;
        let mut add = |level, kind, text: &str| {
            let indent = self.ui(10.0) * level as i32;
            content.next.x = left.x + indent;
            for text in self.letters.wrap(text, left.width - indent) {
                content.push(self.ui(19.0), kind, &text, "");
            }
        };
        let Some([x, y]) = gallery.pixel else {
            return add(0, Kind::Muted, "A click on the picture explains a pixel.");
        };
        let color = gallery
            .picture
            .as_ref()
            .and_then(|picture| picture.pixel(x, y));
        add(0, Kind::Text, &format!("Pixel {x}, {y}"));
        add(0, Kind::Color(color.unwrap_or(0)), "");
        match &gallery.explanation {
            None => {}
            Some(Err(error)) => add(0, Kind::Text, &error.to_string()),
            Some(Ok(explanation)) => {
                for step in explanation.trace.steps.iter().take(MOST_STEPS) {
                    add(step.level, Kind::Text, &step.name);
                    // A line breaks between values only.
                    let words = step.words().map(|word| word.replace(' ', "\u{a0}"));
                    let text = words.collect::<Vec<_>>().join("   ");
                    add(step.level, Kind::Muted, &text);
                }
            }
        }
    }
}

fn progress(share: f64, elapsed: u64, remaining: Option<u64>) -> String {
    let clock = |seconds: u64| format!("{}:{:02}", seconds / 60, seconds % 60);
    let (percent, elapsed) = (100.0 * share, clock(elapsed));
    let remaining = remaining.map_or("?".to_owned(), clock);
    format!("{percent:.0} %  {elapsed} elapsed, {remaining} to go")
}
