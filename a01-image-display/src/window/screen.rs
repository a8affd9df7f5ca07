//! `Screen`: the open window, and its loop.

use std::path::PathBuf;
use std::time::{Duration, Instant};
use std::{env, fs, io};

use common::{Color, Image, fnv1a};
use minifb::{ScaleMode, WindowOptions};
use program::{Gallery, NotShown, Theme};

use super::appearance;
use super::keyboard::Keyboard;
use super::layout::{BAR, PANEL};
use super::mouse::Mouse;
use super::placement::Placement;
use super::ui::Ui;

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
    pub ui: Ui,
    /// The look of the picture in the window.
    pub drawn: String,
    pub theme: Theme,
    pub placement: Placement,
    /// The page of the panel; none if it is hidden.
    pub page: Option<Page>,
    pub notice: Option<(String, Instant)>,
    /// The place of the picture where the left button went down.
    pub pressed: Option<[i32; 2]>,
    /// The time of the first click of a double click.
    pub clicked: Option<Instant>,
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
        window.set_input_callback(Box::new(keyboard.clone()));
        let mut ui = Ui::default();
        ui.set_scale(scale);
        Ok(Self {
            window,
            keyboard,
            ui,
            drawn: String::new(),
            theme,
            placement: Placement::default(),
            page,
            notice: None,
            pressed: None,
            clicked: None,
        })
    }

    /// Shows the picture and executes commands until the window is closed.
    pub fn run(&mut self, gallery: &mut Gallery) -> Result<(), NotShown> {
        let (mut drawn, mut cost) = (Instant::now(), Duration::ZERO);
        let mut has_input = false;
        while self.window.is_open() {
            self.update(gallery);
            for (key, mouse) in self.input() {
                has_input = true;
                (self.ui.key, self.ui.mouse) = (key, mouse);
                if !self.lay_out(gallery) {
                    return Ok(());
                }
                (self.ui.key, self.ui.before) = (String::new(), mouse);
            }
            let wait = if has_input {
                FRAME
            } else if self.drawn != self.look(gallery) {
                // Progress leaves most of the time for keys.
                (3 * cost).clamp(FRAME, REFRESH)
            } else {
                REFRESH
            };
            if drawn.elapsed() < wait {
                self.window.update();
                continue;
            }
            let start = Instant::now();
            self.lay_out(gallery);
            self.draw(gallery);
            let (width, height) = self.window.get_size();
            let pixels = &self.ui.frame.pixels;
            let sent = self.window.update_with_buffer(pixels, width, height);
            sent.map_err(explain)?;
            // Only tests need it.
            let _ = self.report(gallery);
            (drawn, has_input) = (Instant::now(), false);
            cost = drawn - start;
        }
        Ok(())
    }

    /// Takes the news of the rendering and of a watched file.
    fn update(&mut self, gallery: &mut Gallery) {
        if let Err(error) = gallery.reopen() {
            self.notify(format!("error: {error}"));
        }
        if gallery.update()
            && let Some(Ok(image)) = &gallery.outcome
            && let bad @ 1.. = image.count_non_finite()
        {
            self.notify(format!("warning: {bad} pixels are no finite numbers"));
        }
    }

    /// The keys pressed since the last call, and the mouse if it has changed.
    fn input(&mut self) -> Vec<(String, Mouse)> {
        // Releases of keys are not reported while another window has the keyboard.
        if !self.window.is_active() {
            self.keyboard.release_all();
        }
        let (before, mouse) = (self.ui.mouse, self.ui.mouse.now(&self.window));
        let keys = self.keyboard.take().into_iter().map(|key| (key, before));
        let moves = (mouse != before).then(|| (String::new(), mouse));
        keys.chain(moves).collect()
    }

    /// All that changes the picture in the window, in words.
    pub fn look(&self, gallery: &Gallery) -> String {
        let live = gallery.picture.as_ref();
        format!(
            "title: {:?} window: {:?} {:?} scale: {} {:?} pixel: {:?} explained: {} \
             changes: {:?} finished: {}",
            gallery.title(),
            self.window.get_size(),
            self.theme,
            self.ui.scale,
            self.placement,
            gallery.pixel,
            gallery.explanation.is_some(),
            live.map(|live| (live.started, live.changes())),
            gallery.outcome.is_some(),
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
            "{} is_active: {} page: {:?} {:?} picture: {:?} {}",
            self.drawn,
            self.window.is_active(),
            self.page,
            self.ui.mouse,
            picture.map(hash),
            self.ui.words.join(" ")
        );
        // Not even for a moment is the file incomplete.
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
