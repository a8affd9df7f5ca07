//! The menu: the commands of the window, each with its key and its effect.

use common::Renderer;
use program::{Gallery, Theme};

use super::path_entry::PathEntry;
use super::screen::{Page, Screen};
use super::{NO_FILE, PICTURES, SCENE_FILES, choose_file};

const RENDERERS: [(&str, &str, Renderer); 3] = [
    ("The lesson", "L", Renderer::Lesson),
    ("The engine, --fast", "E", Renderer::Engine),
    ("All work, --no-omit", "A", Renderer::AllWork),
];

/// The effects of the mouse and of the other keys.
const HELP: [(&str, &str); 13] = [
    ("Previous, next scene", "← →"),
    ("Next, previous entry", "Tab ↓, Shift Tab ↑"),
    ("Choose", "Enter"),
    ("Back, without closing", "Backspace"),
    ("Back, or close the window", "Esc"),
    ("Zoom, scroll", "wheel, Page ↑ ↓"),
    ("Move the picture", "drag, Shift ← →"),
    ("Rotate the camera", "right drag, Ctrl ← →"),
    ("Explain a pixel", "click"),
    ("Fit to the window", "double click"),
    ("Copy a pixel's numbers", "Ctrl C, click"),
    ("Open a copied path", "Ctrl V"),
    ("Marks at the left", "finished rows"),
];

impl Screen {
    /// Executes the commands of the menu, which may be hidden. False if the window is to be
    /// closed.
    pub fn menu(&mut self, gallery: &mut Gallery) -> bool {
        self.ui.is_shown = self.page() == Some(Page::Menu);
        let uses = gallery.uses();
        if self.ui.entry("Save as PNG", "S") || self.ui.typed("Ctrl S") {
            self.save(gallery);
        }
        if gallery.opens_files() {
            if self.ui.entry("Open …", "Ctrl O") {
                self.choose_and_open(gallery);
            }
            if self.ui.entry("Open by its path", "P") {
                self.path_entry = Some(PathEntry::default());
            }
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
            let is_dark = self.theme == Some(Theme::Dark);
            self.theme = Some(if is_dark { Theme::Light } else { Theme::Dark });
        }
        // Where there are entries or sliders, Tab has already selected one.
        if self.ui.entry("Numbers of the scene", "N") || self.ui.typed("Tab") {
            self.turn_to(Page::Scene);
        }
        if self.ui.entry("This menu", "H") || self.ui.typed("F1") || self.ui.typed("F10") {
            self.turn_to(Page::Menu);
        }
        if self.ui.is_shown {
            self.ui.place(8.0);
            for (number, name) in gallery.names().iter().enumerate() {
                let is_chosen = number == gallery.number();
                if self.ui.choice(name, "", is_chosen) {
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
        match &gallery.outcome {
            None if gallery.is_rendering() => {
                self.notify("the picture is not finished yet".to_owned());
            }
            None | Some(Err(_)) => self.notify("there is no picture to save".to_owned()),
            Some(Ok(image)) => match gallery.save(image) {
                Ok(path) => self.notify(format!("saved {}", common::text::path(&path))),
                Err(error) => self.notify_error(&error.to_string()),
            },
        }
    }

    fn choose_and_open(&mut self, gallery: &mut Gallery) {
        let chosen = if gallery.stage.open.is_some() {
            choose_file("scene files", SCENE_FILES)
        } else {
            choose_file("pictures", PICTURES)
        };
        match chosen {
            None => self.notify(NO_FILE.to_owned()),
            Some(path) => self.open_file(&path, gallery),
        }
    }

    /// Shows the scene of this number.
    pub fn go_to(&mut self, number: usize, gallery: &mut Gallery) {
        self.notice = None;
        self.placement.fit();
        gallery.go_to(number);
    }
}
