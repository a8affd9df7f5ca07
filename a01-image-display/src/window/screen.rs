//! `Screen`: the open window, and its loop.

use std::path::PathBuf;
use std::time::{Duration, Instant};
use std::{env, fs, io};

use common::{Color, Image, fnv1a};
use minifb::{ScaleMode, WindowOptions};
use program::{Gallery, NotShown, Theme};

use super::appearance;
use super::area::Area;
use super::frame::Frame;
use super::hand::Hand;
use super::keyboard::Keyboard;
use super::layout::{BAR, PANEL};
use super::placement::Zoom;
use super::ui::Ui;

/// Updates of keys and mouse per second. A click that begins and ends between two
/// of them is lost.
const UPDATES: usize = 250;
/// The shortest time between two drawings of the window.
const FRAME: Duration = Duration::from_millis(16);
/// After this time the window is drawn although nothing has changed: another window may have
/// covered it.
const REFRESH: Duration = Duration::from_millis(250);

/// A page of the panel beside the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Page {
    Menu,
    /// The numbers of the scene, by sliders.
    Scene,
    /// The numbers behind a pixel.
    Pixel,
}

/// The open window.
pub struct Screen {
    pub window: minifb::Window,
    keyboard: Keyboard,
    pub hand: Hand,
    pub ui: Ui,
    pub frame: Frame,
    /// The look of the picture in the frame.
    pub drawn: String,
    pub theme: Theme,
    pub zoom: Zoom,
    /// The part of the window for the picture.
    pub area: Area,
    /// The page of the panel; none if it is hidden.
    pub page: Option<Page>,
    pub notice: Option<(String, Instant)>,
    is_active: bool,
}

impl Screen {
    pub fn open(gallery: &Gallery) -> Result<Self, NotShown> {
        let theme = gallery.appearance.theme.unwrap_or_else(appearance::theme);
        let percent = gallery.appearance.ui_scale.map(f64::from);
        let scale = percent.map_or_else(appearance::scale, |percent| percent / 100.0);
        let options = WindowOptions {
            resize: true,
            scale_mode: ScaleMode::UpperLeft,
            ..WindowOptions::default()
        };
        let page = Some(Page::Scene).filter(|_| !gallery.sliders.is_empty());
        let panel = page.map_or(0.0, |_| PANEL * scale);
        let [width, height] = window_size(gallery, scale, panel);
        let window = minifb::Window::new(&gallery.title(), width, height, options);
        let mut window = window.map_err(explain)?;
        let keyboard = Keyboard::default();
        window.set_target_fps(UPDATES);
        window.set_input_callback(Box::new(keyboard.clone()));
        let mut ui = Ui::default();
        ui.set_scale(scale);
        Ok(Self {
            window,
            keyboard,
            hand: Hand::default(),
            ui,
            frame: Frame::default(),
            drawn: String::new(),
            theme,
            zoom: Zoom::Fit,
            area: Area::default(),
            page,
            notice: None,
            is_active: false,
        })
    }

    /// Shows the picture and executes commands until the window is closed.
    pub fn run(&mut self, gallery: &mut Gallery) -> Result<(), NotShown> {
        let (mut due, mut drawn) = (Instant::now(), Instant::now());
        let mut cost = FRAME;
        while self.window.is_open() {
            if let Err(error) = gallery.reopen() {
                self.notify(format!("error: {error}"));
            }
            if gallery.update()
                && let Some(Ok(image)) = &gallery.outcome
                && let bad @ 1.. = image.count_non_finite()
            {
                self.notify(format!("warning: {bad} pixels are no finite numbers"));
            }
            let is_active = self.window.is_active();
            // Releases of keys are not reported while another window has the keyboard.
            if std::mem::replace(&mut self.is_active, is_active) && !is_active {
                self.keyboard.release_all();
            }
            let (mouse, keys) = (self.ui.mouse.now(&self.window), self.keyboard.take());
            let before = self.ui.mouse;
            let keys = keys.into_iter().map(|key| (key, before));
            let moves = Some((String::new(), mouse)).filter(|_| mouse != before);
            for (key, mouse) in keys.chain(moves) {
                due = due.min(drawn + FRAME);
                (self.ui.key, self.ui.mouse) = (key, mouse);
                if !self.lay_out(gallery) {
                    return Ok(());
                }
                (self.ui.key, self.ui.before) = (String::new(), mouse);
            }
            if self.drawn != self.look(gallery) {
                // Progress leaves most of the time for keys.
                due = due.min(drawn + FRAME.max(3 * cost));
            }
            if Instant::now() < due {
                self.window.update();
                continue;
            }
            let start = Instant::now();
            self.lay_out(gallery);
            self.draw(gallery);
            let (width, height) = self.window.get_size();
            let sent = self
                .window
                .update_with_buffer(&self.frame.pixels, width, height);
            sent.map_err(explain)?;
            // Only tests need it.
            let _ = self.report(gallery);
            drawn = Instant::now();
            (cost, due) = (drawn - start, drawn + REFRESH);
        }
        Ok(())
    }

    /// All that changes the picture in the window, in words.
    pub fn look(&self, gallery: &Gallery) -> String {
        let live = gallery.picture.as_ref();
        format!(
            "title: {:?} window: {:?} {:?} scale: {} is_active: {} {:?} pixel: {:?} \
             explained: {} changes: {:?} finished: {}",
            gallery.title(),
            self.window.get_size(),
            self.theme,
            self.ui.scale,
            self.is_active,
            self.placement(gallery),
            gallery.pixel,
            gallery.explanation.is_some(),
            live.map(|live| (live.started, live.changes())),
            gallery.outcome.is_some(),
        )
    }

    /// Writes the state that is on the screen, and the hash of the bytes of a finished picture,
    /// to the file that the environment variable `WORKBOOK_WINDOW_STATE` names: the tests read it.
    fn report(&self, gallery: &Gallery) -> io::Result<()> {
        let Some(path) = env::var_os("WORKBOOK_WINDOW_STATE") else {
            return Ok(());
        };
        let outcome = gallery.outcome.as_ref();
        // Not by `to_rgb8`, which would start threads that a test does not expect.
        let bytes = |color: &Color| gallery.options.transfer.bytes(*color);
        let bytes = |image: &Image| image.pixels().iter().flat_map(bytes).collect::<Vec<_>>();
        let image = outcome.and_then(|outcome| outcome.as_ref().ok());
        let hash = image.map(|image| fnv1a(&bytes(image)));
        let state = format!(
            "{} zoom: {:?} page: {:?} {:?} picture: {hash:?} {:?}",
            self.drawn, self.zoom, self.page, self.ui.mouse, self.ui.items
        );
        // Not even for a moment is the file incomplete.
        let path = PathBuf::from(path);
        let new = path.with_extension("new");
        fs::write(&new, state)?;
        fs::rename(new, path)
    }

    pub fn notify(&mut self, notice: String) {
        self.notice = Some((notice, Instant::now()));
    }
}

/// The size in which the window opens: the picture's, enlarged by a whole scale, and shrunk
/// where a side is too long for nearly every screen, with room for the bars and the panel.
/// minifb does not know the size of this screen.
fn window_size(gallery: &Gallery, scale: f64, panel: f64) -> [usize; 2] {
    let sides = [gallery.size().width(), gallery.size().height()].map(f64::from);
    let most = (1280.0 * scale / sides[0]).min(720.0 * scale / sides[1]);
    let fit = most.min(scale.floor().max(1.0));
    let width = (sides[0] * fit).round().max(320.0 * scale) + panel.round();
    let height = (sides[1] * fit).round().max(160.0 * scale) + (BAR * scale).round();
    [width, height].map(|side| side as usize)
}

fn explain(error: minifb::Error) -> NotShown {
    NotShown::NoWindow(match error {
        minifb::Error::WindowCreate(reason) => format!("no display to open it on ({reason})"),
        error => format!("the display refused the picture ({error})"),
    })
}
