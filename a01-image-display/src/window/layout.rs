//! The layout of the window: the picture, the panel beside it, and the line below.

use program::{Gallery, Theme};

use super::appearance::Colors;
use super::area::Area;
use super::screen::{Page, Screen};

/// Height of the bar and width of the panel, at scale 1.
pub const BAR: f64 = 30.0;
pub const PANEL: f64 = 300.0;

impl Screen {
    /// Draws all but the picture, and executes the commands of a person. False if the window is
    /// to be closed.
    pub fn layout(&mut self, gallery: &mut Gallery) -> bool {
        let [width, height] = self.size.map(|side| side as i32);
        self.ui.frame.resize(width as usize, height as usize);
        self.ui.colors = Colors::of(self.theme.unwrap_or(Theme::Dark));
        let (bar, margin) = (self.ui.px(BAR), self.ui.px(12.0));
        let top = height - bar;
        let side = self.page().map_or(0, |_| self.ui.px(PANEL).min(width / 2));
        let area = Area::new(0, 0, (width - side).max(1), top.max(1));
        self.placement.place(gallery.size(), area);
        self.ui.begin(Area::new(width - side, bar, side, top - bar));
        if !self.menu(gallery) {
            return false;
        }
        match self.page() {
            Some(Page::Scene) => self.add_sliders(gallery),
            Some(Page::Pixel) => self.add_pixel(gallery),
            Some(Page::Menu) | None => {}
        }
        self.ui.end();
        self.add_tabs(Area::new(width - side, 0, side, bar));
        let below = Area::new(0, top, width, bar);
        self.ui.frame.fill(below, self.ui.colors.bar);
        self.add_status(below.inset(margin, 0), gallery);
        self.navigate(gallery)
    }

    fn add_sliders(&mut self, gallery: &mut Gallery) {
        if gallery.sliders.is_empty() {
            let hint = "This scene has no numbers to change.";
            self.ui.text(0, self.ui.colors.muted, hint);
        }
        for number in 0..gallery.sliders.len() {
            if let Some(to) = self.ui.slider(&gallery.sliders[number]) {
                gallery.slide(number, to);
            }
        }
    }

    /// Adds the names of all pages above the panel.
    fn add_tabs(&mut self, mut area: Area) {
        let colors = self.ui.colors;
        self.ui.frame.fill(area, colors.bar);
        area.width /= 3;
        for page in [Page::Menu, Page::Scene, Page::Pixel] {
            let is_shown = self.page() == Some(page);
            let color = if is_shown { colors.text } else { colors.muted };
            let mut line = Area {
                y: area.y + area.height - self.ui.px(2.0),
                height: self.ui.px(2.0),
                ..area
            };
            let edge = if is_shown {
                colors.accent
            } else {
                colors.raised
            };
            line = line.inset(self.ui.px(4.0), 0);
            self.ui.frame.fill(line, edge);
            let name = area.inset(self.ui.px(22.0).min(area.width / 8), 0);
            self.ui.write(name, color, &format!("{page:?}"), "");
            if self.ui.clicked(area) {
                self.turn_to(page);
            }
            area.x += area.width;
        }
    }

    /// Adds the line below all others: progress, the pixel under the mouse, or the scene.
    fn add_status(&mut self, area: Area, gallery: &Gallery) {
        let pixel = self.placement.pixel(self.ui.mouse.at);
        let text = match (&gallery.picture, pixel) {
            (Some(live), _) if gallery.is_rendering() => {
                let fraction = live.fraction().min(1.0);
                let done = f64::from(area.width + 2 * area.x) * fraction;
                let done = Area::new(0, area.y, done as i32, self.ui.px(3.0));
                self.ui.frame.fill(done, self.ui.colors.accent);
                let mut text = format!("{:.0} %  {}", 100.0 * fraction, live.times());
                let hint = "   E: the engine draws the same sooner";
                let has_room = self.ui.letters.width(&text) + self.ui.letters.width(hint)
                    < area.width - self.ui.px(60.0);
                if gallery.is_slow() && has_room {
                    text += hint;
                }
                text
            }
            (Some(live), Some([x, y])) => {
                let [_, r, g, b] = live.pixel(x, y).unwrap_or(0).to_be_bytes();
                format!("column {x}, row {y}: ({r}, {g}, {b})")
            }
            _ => format!("{}   H shows the menu", gallery.name()),
        };
        let zoom = format!("{:.0} %", 100.0 * self.placement.scale);
        self.ui.write(area, self.ui.colors.muted, &text, &zoom);
    }
}
