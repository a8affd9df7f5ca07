//! `Screen`: all that the window shows and remembers, without the window of the system.
//!
//! Inputs change it and drawing reads it, so that tests need no display.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use std::{env, fs, io};

use common::{Color, Image, fnv1a};
use program::{Gallery, Theme};

use super::appearance;
use super::clipboard::Clipboard;
use super::keyboard::Press;
use super::layout::{BAR, PANEL};
use super::mouse::Mouse;
use super::notices::Notice;
use super::path_entry::PathEntry;
use super::placement::Placement;
use super::ui::Ui;

/// A page of the panel beside the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Page {
    Menu,
    /// The numbers of the scene, by sliders.
    Scene,
    /// The numbers behind a pixel.
    Pixel,
}

/// What the window shows and remembers.
#[derive(Default)]
pub struct Screen {
    /// Width and height of the window, in pixels.
    pub size: [u32; 2],
    /// Whether the window has the keyboard.
    pub is_active: bool,
    pub ui: Ui,
    /// The fingerprint of the picture that was drawn last.
    pub drawn: String,
    pub theme: Option<Theme>,
    pub placement: Placement,
    /// The page of the panel is the last one, and those before are returned to; the panel is hidden
    /// if there is none.
    pages: Vec<Page>,
    pub notice: Option<Notice>,
    /// The path that is being typed.
    pub path_entry: Option<PathEntry>,
    pub clipboard: Clipboard,
    /// The place of the picture where the left button went down.
    pub pressed: Option<[i32; 2]>,
    /// Time and place of the first click of a double click.
    pub clicked: Option<(Instant, [i32; 2])>,
}

impl Screen {
    /// Chooses theme, scale and size, before the window is opened.
    pub fn begin(
        &mut self,
        gallery: &Gallery,
        system: Option<winit::window::Theme>,
        display_scale: f64,
    ) {
        let system = system.map(|theme| match theme {
            winit::window::Theme::Dark => Theme::Dark,
            winit::window::Theme::Light => Theme::Light,
        });
        let chosen = gallery.appearance.theme.or(system);
        self.theme = Some(chosen.unwrap_or_else(appearance::theme));
        self.rescale(gallery, display_scale);
        if !gallery.sliders.is_empty() {
            self.show_page(Page::Scene);
        }
        self.size = window_size(gallery, self.ui.scale, self.page().is_some());
    }

    /// Takes the scale of the display, unless the command line has another one.
    pub fn rescale(&mut self, gallery: &Gallery, display_scale: f64) {
        let percent = gallery.appearance.ui_scale.map(f64::from);
        let scale = percent.map_or(display_scale, |percent| percent / 100.0);
        self.ui.set_scale(scale);
    }

    /// Takes the news of the rendering and of watched files.
    pub fn update(&mut self, gallery: &mut Gallery) {
        self.notice.take_if(|notice| notice.ends_in().is_zero());
        if gallery.update()
            && let Some(Ok(image)) = &gallery.outcome
            && let bad @ 1.. = image.count_non_finite()
        {
            self.notify(format!("warning: {bad} pixels are no finite numbers"));
        }
    }

    /// Takes a pressed key, and the mouse as it is now. False if the window is to be closed.
    pub fn input(&mut self, press: Press, mouse: Mouse, gallery: &mut Gallery) -> bool {
        self.ui.mouse = mouse;
        self.ui.key = self.type_path(press, gallery);
        let page = self.page();
        let stays = self.layout(gallery);
        (self.ui.key, self.ui.before) = (String::new(), mouse);
        // The next input may come before the window is drawn, and is for the new page.
        if stays && self.page() != page {
            self.layout(gallery);
        }
        stays
    }

    /// Draws the window into its frame.
    pub fn draw(&mut self, gallery: &mut Gallery) {
        let scroll = self.ui.scroll;
        self.layout(gallery);
        if self.ui.scroll != scroll {
            // Its items tell how far the panel may be scrolled.
            self.layout(gallery);
        }
        self.draw_picture(gallery);
        // Only tests need it.
        let _ = self.report(gallery);
    }

    /// Opens a scene file or a picture, and shows it.
    pub fn open_file(&mut self, path: &Path, gallery: &mut Gallery) {
        self.notice = None;
        match gallery.open(path) {
            Ok(()) => self.placement.fit(),
            Err(error) => self.notify_error(&error.to_string()),
        }
    }

    /// All that changes the picture in the window, in words.
    pub fn fingerprint(&self, gallery: &Gallery) -> String {
        let live = gallery.picture.as_ref();
        format!(
            "title: {:?} window: {:?} {:?} scale: {} {:?} pixel: {:?} explained: {} {} \
             changes: {:?} finished: {} over it: {:?}",
            gallery.title(),
            (self.size[0], self.size[1]),
            self.theme.unwrap_or(Theme::Dark),
            self.ui.scale,
            self.placement,
            gallery.pixel,
            gallery.explanation.is_some(),
            gallery.influences.is_some(),
            live.map(|live| (live.started, live.changes())),
            gallery.outcome.is_some(),
            self.messages(gallery),
        )
    }

    /// Writes the state that is on the screen, and the hash of the bytes of a finished picture,
    /// to the file that the environment variable `WORKBOOK_WINDOW_STATE` names: the tests read it.
    fn report(&mut self, gallery: &Gallery) -> io::Result<()> {
        let Some(path) = env::var_os("WORKBOOK_WINDOW_STATE").map(PathBuf::from) else {
            return Ok(());
        };
        // Not by `to_rgb8`, which would start threads that a test does not expect.
        let bytes = |color: &Color| gallery.options.transfer.bytes(*color);
        let hash =
            |image: &Image| fnv1a(&image.pixels().iter().flat_map(bytes).collect::<Vec<_>>());
        let picture = gallery.outcome.as_ref().and_then(|it| it.as_ref().ok());
        let state = format!(
            "{} is_active: {} page: {:?} {:?} picture: {:?} path: {:?} {}",
            self.drawn,
            self.is_active,
            self.page(),
            self.ui.mouse,
            picture.map(hash),
            self.path_entry,
            self.ui.words.join(" ")
        );
        // Not even for a moment is the file incomplete.
        let new = path.with_extension("new");
        fs::write(&new, state)?;
        fs::rename(new, path)
    }

    /// The page of the panel; none if it is hidden.
    pub fn page(&self) -> Option<Page> {
        self.pages.last().copied()
    }

    /// Shows a page of the panel.
    pub fn show_page(&mut self, page: Page) {
        self.pages.retain(|before| *before != page);
        self.pages.push(page);
        (self.ui.scroll, self.ui.selected) = (0, None);
    }

    /// Returns to the page before, or hides the panel.
    pub fn leave_page(&mut self) {
        self.pages.pop();
        (self.ui.scroll, self.ui.selected) = (0, None);
    }

    /// Shows a page of the panel, or leaves it.
    pub fn turn_to(&mut self, page: Page) {
        if self.page() == Some(page) {
            self.leave_page();
        } else {
            self.show_page(page);
            (self.ui.selected, self.ui.is_sought) = (Some(0), true);
        }
    }

    /// Shows a notice for some seconds.
    pub fn notify(&mut self, text: String) {
        self.notice = Some(Notice::new(text, false));
    }

    /// Shows an error for some seconds.
    pub fn notify_error(&mut self, error: &str) {
        self.notice = Some(Notice::new(format!("error: {error}"), true));
    }

    /// The time until the notice disappears.
    pub fn notice_ends_in(&self) -> Option<Duration> {
        self.notice.as_ref().map(Notice::ends_in)
    }
}

/// The size in which the window opens: the picture's, enlarged by a whole scale, and shrunk
/// where a side is too long for nearly every screen, with room for the bars and the panel.
fn window_size(gallery: &Gallery, scale: f64, has_panel: bool) -> [u32; 2] {
    let panel = if has_panel { PANEL * scale } else { 0.0 };
    let sides = [gallery.size().width(), gallery.size().height()].map(f64::from);
    let most = (1280.0 * scale / sides[0]).min(720.0 * scale / sides[1]);
    let fit = most.min(scale.floor().max(1.0));
    let width = (sides[0] * fit).round().max(320.0 * scale) + panel.round();
    let height = (sides[1] * fit).round().max(160.0 * scale) + (BAR * scale).round();
    [width, height].map(|side| side as u32)
}
