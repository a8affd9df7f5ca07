//! The layout of the window: the picture, the panel beside it, and the lines below.

use std::time::Duration;

use program::Gallery;

use super::appearance::Colors;
use super::area::Area;
use super::screen::{Page, Screen};

/// Height of the bar and width of the panel, at scale 1.
pub const BAR: f64 = 30.0;
pub const PANEL: f64 = 300.0;

/// Time until a notice disappears.
const NOTICE: Duration = Duration::from_secs(6);

/// Most steps of a pixel that are listed.
const MOST_STEPS: usize = 300;

impl Screen {
    /// Draws all but the picture, and executes the commands of a person. False if the window is
    /// to be closed.
    pub fn lay_out(&mut self, gallery: &mut Gallery) -> bool {
        let (width, height) = self.window.get_size();
        self.ui.frame.resize(width, height);
        self.ui.colors = Colors::of(self.theme);
        let (width, height, margin) = (width as i32, height as i32, self.ui.px(12.0));
        let messages = self.messages(gallery).into_iter();
        let wrap = |text: String| self.ui.letters.wrap(&text, width - 2 * margin);
        let lines: Vec<_> = messages.flat_map(wrap).collect();
        let (bar, line) = (self.ui.px(BAR), self.ui.px(20.0));
        let top = height - bar - line * lines.len() as i32;
        let side = self.page.map_or(0, |_| self.ui.px(PANEL).min(width / 2));
        let area = Area::new(0, 0, (width - side).max(1), top.max(1));
        self.placement.place(gallery.size(), area);
        self.ui.begin(Area::new(width - side, bar, side, top - bar));
        if !self.menu(gallery) {
            return false;
        }
        match self.page {
            Some(Page::Scene) => {
                for number in 0..gallery.sliders.len() {
                    if let Some(to) = self.ui.slider(&gallery.sliders[number]) {
                        gallery.slide(number, to);
                    }
                }
            }
            Some(Page::Pixel) => self.add_pixel(gallery),
            Some(Page::Menu) | None => {}
        }
        self.ui.end();
        self.add_tabs(Area::new(width - side, 0, side, bar));

        let below = Area::new(0, top, width, height - top);
        self.ui.frame.fill(below, self.ui.colors.bar);
        let mut area = Area::new(margin, top, width - 2 * margin, line);
        for text in lines {
            self.ui.write(area, self.ui.colors.text, &text, "");
            area.y += line;
        }
        area.height = bar;
        self.add_status(area, gallery);

        for (key, lines) in [("PageUp", -8), ("PageDown", 8)] {
            if self.ui.typed(key) {
                self.ui.scroll += self.ui.px(20.0) * lines;
            }
        }
        self.handle(gallery);
        if !self.ui.typed("Escape") || self.ui.leave() {
            return true;
        }
        let is_explained = gallery.pixel.is_some();
        gallery.explain(None);
        is_explained
    }

    /// The error of the picture, and the notice.
    fn messages(&mut self, gallery: &Gallery) -> Vec<String> {
        self.notice.take_if(|(_, since)| since.elapsed() > NOTICE);
        let error = gallery.outcome.as_ref().and_then(|it| it.as_ref().err());
        let error = error.map(|error| format!("error: {error}"));
        let notice = self.notice.as_ref().map(|(notice, _)| notice.clone());
        error.into_iter().chain(notice).collect()
    }

    /// Adds the names of all pages above the panel.
    fn add_tabs(&mut self, mut area: Area) {
        self.ui.frame.fill(area, self.ui.colors.bar);
        area.width /= 3;
        for page in [Page::Menu, Page::Scene, Page::Pixel] {
            let name = area.inset(self.ui.px(22.0), 0);
            if self.page == Some(page) {
                self.ui.mark(name);
            }
            self.ui
                .write(name, self.ui.colors.text, &format!("{page:?}"), "");
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
            (Some(live), _) if gallery.outcome.is_none() => {
                let fraction = live.fraction().min(1.0);
                let done = f64::from(area.width + 2 * area.x) * fraction;
                let done = Area::new(0, area.y, done as i32, self.ui.px(3.0));
                self.ui.frame.fill(done, self.ui.colors.accent);
                format!("{:.0} %  {}", 100.0 * fraction, live.times())
            }
            (Some(live), Some([x, y])) => {
                let [_, r, g, b] = live.pixel(x, y).unwrap_or(0).to_be_bytes();
                format!("column {x}, row {y}: ({r}, {g}, {b})")
            }
            _ => format!("{}   H shows the menu", gallery.scene.name),
        };
        let zoom = format!("{:.0} %", 100.0 * self.placement.scale);
        self.ui.write(area, self.ui.colors.muted, &text, &zoom);
    }

    /// Adds the numbers behind the pixel that is explained.
    fn add_pixel(&mut self, gallery: &Gallery) {
        let Colors { text, muted, .. } = self.ui.colors;
        let Some([x, y]) = gallery.pixel else {
            let hint = "A click on the picture explains a pixel.";
            return self.ui.text(0, muted, hint);
        };
        self.ui.text(0, text, &format!("Pixel {x}, {y}"));
        let sample = self.ui.place(19.0).inset(0, self.ui.px(3.0));
        let picture = gallery.picture.as_ref();
        let color = picture.and_then(|picture| picture.pixel(x, y));
        self.ui.frame.fill(sample, color.unwrap_or(0));
        match &gallery.explanation {
            None => {}
            Some(Err(error)) => self.ui.text(0, text, &error.to_string()),
            Some(Ok(explanation)) => {
                for step in explanation.trace.steps.iter().take(MOST_STEPS) {
                    self.ui.text(step.level, text, &step.name);
                    // A line breaks between values only.
                    let words = step.words().map(|word| word.replace(' ', "\u{a0}"));
                    let words = words.collect::<Vec<_>>().join("   ");
                    self.ui.text(step.level, muted, &words);
                }
            }
        }
    }
}
