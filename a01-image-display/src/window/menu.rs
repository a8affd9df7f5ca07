//! The menu: the commands of the window, each with its key and its effect.

use common::Renderer;
use program::{Gallery, Theme};

use super::screen::{Page, Screen};
use super::{NO_FILE, choose_file};

const RENDERERS: [(&str, &str, Renderer); 3] = [
    ("The lesson", "L", Renderer::Lesson),
    ("The engine, --fast", "E", Renderer::Engine),
    ("All work, --no-omit", "A", Renderer::AllWork),
];

/// The effects of the mouse and of the other keys.
const HELP: [(&str, &str); 8] = [
    ("Previous, next scene", "← →"),
    ("Menu, sliders, pixels", "↑ ↓ ← →"),
    ("Choose; back or close", "Enter; Esc"),
    ("Zoom, scroll", "wheel, Page ↑ ↓"),
    ("Move the picture", "drag, Shift ← →"),
    ("Turn the camera", "right drag, Ctrl ← →"),
    ("Explain a pixel", "click"),
    ("Fit to the window", "double click"),
];

impl Screen {
    /// Executes the commands of the menu, which may be hidden. False if the window is to be
    /// closed.
    pub fn menu(&mut self, gallery: &mut Gallery) -> bool {
        self.ui.is_shown = self.page == Some(Page::Menu);
        let uses = gallery.scene.uses;
        if self.ui.entry("Save as PNG", "S") || self.ui.typed("Ctrl S") {
            self.save(gallery);
        }
        if uses.file && self.ui.entry("Open …", "Ctrl O") {
            self.open_file(gallery);
        }
        if self.ui.entry("Close", "Ctrl W") {
            return false;
        }
        for (text, key, renderer) in RENDERERS.into_iter().filter(|_| uses.sampling) {
            if self.ui.choice(text, key, renderer == gallery.renderer()) {
                gallery.render_with(renderer);
            }
        }
        if self.ui.entry("All back to the start", "R") {
            gallery.reset();
        }
        if self.ui.entry("Explain a pixel", "I") {
            self.explain(gallery);
        }
        for (text, key, larger) in [("Zoom in", "+", true), ("Zoom out", "-", false)] {
            if self.ui.entry(text, key) {
                self.placement.zoom(larger, self.ui.mouse.at);
            }
        }
        if self.ui.entry("Fit to the window", "0") {
            self.placement.fit();
        }
        let larger = ("Larger letters", "Ctrl +", 1.125);
        for (text, key, factor) in [larger, ("Smaller letters", "Ctrl -", 1.0 / 1.125)] {
            if self.ui.entry(text, key) {
                self.ui.set_scale(self.ui.scale * factor);
            }
        }
        if self.ui.entry("Dark or light", "D") {
            let is_dark = self.theme == Theme::Dark;
            self.theme = if is_dark { Theme::Light } else { Theme::Dark };
        }
        if self.ui.entry("Numbers of the scene", "N") || self.ui.typed("Tab") {
            self.turn_to(Page::Scene);
        }
        if self.ui.entry("This menu", "H") || self.ui.typed("F1") || self.ui.typed("F10") {
            self.turn_to(Page::Menu);
        }
        if self.ui.is_shown {
            self.ui.place(8.0);
            let stage = gallery.stage;
            for (number, scene) in stage.scenes.iter().enumerate() {
                let is_chosen = scene.name == gallery.scene.name;
                if self.ui.choice(scene.name, "", is_chosen) {
                    self.go_to(number, gallery);
                }
            }
            self.ui.place(8.0);
            for (text, key) in HELP {
                let area = self.ui.place(24.0);
                self.ui.write(area, self.ui.colors.muted, text, key);
            }
        }
        true
    }

    fn save(&mut self, gallery: &Gallery) {
        self.notify(match &gallery.outcome {
            None => "the picture is not finished yet".to_owned(),
            Some(Err(_)) => "there is no picture to save".to_owned(),
            Some(Ok(image)) => match gallery.save(image) {
                Ok(path) => format!("saved {}", common::text::path(&path)),
                Err(error) => format!("error: {error}"),
            },
        });
    }

    fn open_file(&mut self, gallery: &mut Gallery) {
        match choose_file() {
            None => self.notify(NO_FILE.to_owned()),
            file => {
                gallery.options.open = file;
                self.go_to(gallery.number(), gallery);
            }
        }
    }

    /// Shows a page of the panel, or hides it.
    pub fn turn_to(&mut self, page: Page) {
        self.page = Some(page).filter(|page| self.page != Some(*page));
        (self.ui.scroll, self.ui.selected, self.ui.is_sought) = (0, Some(0), true);
    }

    /// Shows the scene of this number.
    pub fn go_to(&mut self, number: usize, gallery: &mut Gallery) {
        self.notice = None;
        self.placement.fit();
        gallery.go_to(number);
        self.window.set_title(&gallery.title());
    }
}
