//! `Screen`: the open window, and its loop.

use std::fs::File;
use std::io::Write;
use std::time::{Duration, Instant};

use common::{Color, Image, fnv1a};
use minifb::{ScaleMode, WindowOptions};
use program::{Gallery, NotShown, Theme};

use super::appearance;
use super::command::{Command, Page};
use super::content::{BAR, Content, PANEL};
use super::frame::Frame;
use super::keyboard::Keyboard;
use super::letters::Letters;
use super::mouse::Mouse;
use super::placement::Zoom;

/// Updates of keys and mouse per second. A click that begins and ends between two
/// of them is lost.
const UPDATES: usize = 250;
/// The shortest time between two drawings of the window.
const FRAME: Duration = Duration::from_millis(16);
/// After this time the window is sent to the screen although nothing has
/// changed: another window may have covered it.
const REFRESH: Duration = Duration::from_millis(250);
/// Time until a notice disappears.
const NOTICE: Duration = Duration::from_secs(6);

/// The open window.
pub struct Screen {
    pub window: minifb::Window,
    keyboard: Keyboard,
    pub mouse: Mouse,
    pub letters: Letters,
    pub frame: Frame,
    pub theme: Theme,
    pub scale: f64,
    pub zoom: Zoom,
    /// The page of the panel; none if it is hidden.
    pub page: Option<Page>,
    /// The command of the entry or slider that the arrow keys control.
    pub selected: Option<Command>,
    /// Way of the page upwards, in pixels.
    pub scroll: i32,
    pub notice: Option<(String, Instant)>,
    is_active: bool,
    /// The file that the environment variable `WORKBOOK_WINDOW_LOG` names: the tests read it.
    log: Option<File>,
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
        let (width, height) = window_size(gallery, scale, panel);
        let window = minifb::Window::new(&gallery.title(), width, height, options);
        let path = std::env::var_os("WORKBOOK_WINDOW_LOG");
        let mut screen = Self {
            window: window.map_err(explain)?,
            keyboard: Keyboard::default(),
            mouse: Mouse::default(),
            letters: Letters::new(),
            frame: Frame::default(),
            theme,
            scale,
            zoom: Zoom::Fit,
            page,
            selected: None,
            scroll: 0,
            notice: None,
            is_active: false,
            log: path.and_then(|path| File::create(path).ok()),
        };
        screen.set_scale(scale);
        screen.window.set_target_fps(UPDATES);
        screen
            .window
            .set_input_callback(Box::new(screen.keyboard.clone()));
        Ok(screen)
    }

    /// Shows the picture and executes commands until the window is closed.
    pub fn run(&mut self, gallery: &mut Gallery) -> Result<(), NotShown> {
        let (mut drawn, mut drawn_at) = (String::new(), Instant::now());
        let mut content = self.content(gallery);
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
            for command in self.commands(&content, gallery) {
                if !self.execute(command, &content, gallery) {
                    return Ok(());
                }
                content = self.content(gallery);
                drawn.clear();
            }
            let state = self.state(gallery);
            let is_drawn = drawn == state;
            if drawn_at.elapsed() < if is_drawn { REFRESH } else { FRAME } {
                self.window.update();
                continue;
            }
            if !is_drawn {
                content = self.content(gallery);
                self.draw(&content, gallery);
            }
            let (width, height) = self.window.get_size();
            let sent = self
                .window
                .update_with_buffer(&self.frame.pixels, width, height);
            sent.map_err(explain)?;
            drawn_at = Instant::now();
            if !is_drawn {
                self.log(&state, &content, gallery);
                drawn = state;
            }
        }
        Ok(())
    }

    /// All that changes the window, in words. If it differs, the window is drawn again.
    fn state(&self, gallery: &Gallery) -> String {
        let live = gallery.picture.as_ref();
        let seconds = live
            .filter(|_| gallery.outcome.is_none())
            .map(|live| live.elapsed().as_secs());
        let sliders: Vec<_> = gallery.sliders.iter().map(|slider| slider.at).collect();
        format!(
            "title: {:?} window: {:?} {:?} scale: {} zoom: {:?} page: {:?} selected: {:?} scroll: {} \
             is_active: {} {:?} notice: {:?} pixel: {:?} explained: {} sliders: {sliders:?} \
             changes: {:?} {seconds:?} finished: {}",
            gallery.title(),
            self.window.get_size(),
            self.theme,
            self.scale,
            self.zoom,
            self.page,
            self.selected,
            self.scroll,
            self.is_active,
            self.mouse,
            self.notice(),
            gallery.pixel,
            gallery.explanation.is_some(),
            live.map(|live| (live.started, live.changes())),
            gallery.outcome.is_some(),
        )
    }

    /// Writes a state that is on the screen, and the hash of the bytes of a finished picture.
    fn log(&mut self, state: &str, content: &Content, gallery: &Gallery) {
        if let Some(log) = &mut self.log {
            let image = gallery
                .outcome
                .as_ref()
                .and_then(|outcome| outcome.as_ref().ok());
            // Not by `to_rgb8`, which would start threads that a test does not expect.
            let bytes = |color: &Color| gallery.options.transfer.bytes(*color);
            let bytes = |image: &Image| image.pixels().iter().flat_map(bytes).collect::<Vec<_>>();
            let hash = image.map(|image| fnv1a(&bytes(image)));
            let _ = writeln!(log, "{state} picture: {hash:?} {content:?}");
        }
    }

    /// The commands of keys and mouse since the last call.
    fn commands(&mut self, content: &Content, gallery: &mut Gallery) -> Vec<Command> {
        let is_active = self.window.is_active();
        // Releases of keys are not reported while another window has the keyboard.
        if std::mem::replace(&mut self.is_active, is_active) && !is_active {
            self.keyboard.release_all();
        }
        let mut commands = self.keyboard.take();
        commands.extend(self.mouse_commands(content, gallery));
        commands
    }

    pub fn set_scale(&mut self, scale: f64) {
        self.scale = scale;
        self.letters.resize(13.0 * scale);
    }

    pub fn notify(&mut self, notice: String) {
        self.notice = Some((notice, Instant::now()));
    }

    pub fn notice(&self) -> Option<&str> {
        let (notice, since) = self.notice.as_ref()?;
        (since.elapsed() <= NOTICE).then_some(notice)
    }
}

/// The size in which the window opens: the picture's, enlarged by a whole scale, and shrunk
/// where a side is too long for nearly every screen, with room for the bars and the panel.
/// minifb does not know the size of this screen.
fn window_size(gallery: &Gallery, scale: f64, panel: f64) -> (usize, usize) {
    let size = gallery.size();
    let (width, height) = (f64::from(size.width()), f64::from(size.height()));
    let most = (1280.0 * scale / width).min(720.0 * scale / height);
    let fit = most.min(scale.floor().max(1.0));
    let side = |side: f64, smallest: f64| (side * fit).round().max(smallest * scale);
    let height = side(height, 160.0) + (BAR * scale).round();
    (
        (side(width, 320.0) + panel.round()) as usize,
        height as usize,
    )
}

fn explain(error: minifb::Error) -> NotShown {
    NotShown::NoWindow(match error {
        minifb::Error::WindowCreate(reason) => format!("no display to open it on ({reason})"),
        error => format!("the display refused the picture ({error})"),
    })
}
