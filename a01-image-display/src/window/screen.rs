//! `Screen`: the open window and its picture.

use std::time::{Duration, Instant};

use common::{Error, Image, Size};
use minifb::{Menu, ScaleMode, WindowOptions};
use program::{Gallery, NotShown};

use super::command::Command;
use super::drawing::Look;
use super::frame::Frame;
use super::input::Input;
use super::keyboard::Keyboard;
use super::log::Log;
use super::menu_bar::{self, ITEMS, MenuBar, PLATFORM_HAS_MENU};
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

/// The open window and its picture.
pub struct Screen {
    pub window: minifb::Window,
    pub keyboard: Keyboard,
    pub input: Input,
    pub menu: MenuBar,
    pub frame: Frame,
    pub title: String,
    pub size: Size,
    /// The finished picture as it is shown.
    pub pixels: Vec<u32>,
    /// The finished picture as it is saved, or the reason for its absence; none while it
    /// is rendered.
    pub outcome: Option<Result<Image, String>>,
    pub zoom: Zoom,
    pub inspects: bool,
    pub helps: bool,
    pub notice: Option<(String, Instant)>,
    drawn: Option<Look>,
    pub log: Log,
}

impl Screen {
    pub fn open(gallery: &Gallery, size: Size) -> Result<Self, NotShown> {
        let options = WindowOptions {
            resize: true,
            scale_mode: ScaleMode::UpperLeft,
            ..WindowOptions::default()
        };
        let title = gallery.title();
        let (width, height) = window_size(size);
        let mut window = minifb::Window::new(&title, width, height, options).map_err(explain)?;
        window.set_target_fps(UPDATES);
        let keyboard = Keyboard::default();
        window.set_input_callback(Box::new(keyboard.clone()));
        if PLATFORM_HAS_MENU && let Ok(mut file) = Menu::new("File") {
            for (id, (label, ..)) in ITEMS.into_iter().enumerate() {
                file.add_item(label, id).build();
            }
            window.add_menu(&file);
        }
        Ok(Self {
            window,
            keyboard,
            input: Input::default(),
            menu: MenuBar::new(gallery.opens_files()),
            frame: Frame::default(),
            title,
            size,
            pixels: Vec::new(),
            outcome: None,
            zoom: Zoom::Fit,
            inspects: false,
            helps: false,
            notice: None,
            drawn: None,
            log: Log::open(),
        })
    }

    /// Shows the picture and executes commands until the window is closed.
    pub fn run(&mut self, gallery: &mut Gallery) -> Result<(), NotShown> {
        let mut drawn_at = Instant::now();
        while self.window.is_open() {
            if let Err(error) = gallery.reopen() {
                self.notify(format!("error: {error}"));
            }
            if let Some(outcome) = gallery.finished() {
                self.finish(gallery, outcome);
            }
            for command in self.commands() {
                if command == Command::Close {
                    return Ok(());
                }
                if self.execute(command, gallery)
                    && let Err(error) = gallery.start()
                {
                    self.finish(gallery, Err(error));
                }
            }
            let live = gallery.picture();
            if let Some(live) = live {
                self.size = live.size();
            }
            let look = self.look(live);
            let is_drawn = self.drawn.as_ref() == Some(&look);
            if drawn_at.elapsed() < if is_drawn { REFRESH } else { FRAME } {
                self.window.update();
            } else {
                if !is_drawn {
                    self.draw(live, &look);
                }
                let (width, height) = look.window;
                self.window
                    .update_with_buffer(self.frame.pixels(), width, height)
                    .map_err(explain)?;
                drawn_at = Instant::now();
                self.drawn = Some(look);
            }
            if let Some(drawn) = &self.drawn {
                self.log.write(drawn, &self.input);
            }
        }
        Ok(())
    }

    /// Shows a finished picture, or an error.
    pub fn finish(&mut self, gallery: &Gallery, outcome: Result<Image, Error>) {
        self.drawn = None;
        self.pixels.clear();
        if let Ok(image) = &outcome {
            let transfer = gallery.transfer();
            let bad = image.count_non_finite();
            if bad > 0 {
                self.notify(format!("warning: {bad} pixels are no finite numbers"));
            }
            self.size = image.size();
            self.pixels
                .extend(image.pixels().iter().map(|color| transfer.pack(*color)));
        }
        self.outcome = Some(outcome.map_err(|error| format!("error: {error}")));
    }

    pub fn notify(&mut self, notice: String) {
        self.notice = Some((notice, Instant::now()));
    }

    pub fn notice(&self) -> Option<&str> {
        let (notice, since) = self.notice.as_ref()?;
        (since.elapsed() <= NOTICE).then_some(notice)
    }
}

/// The size in which the window opens: the picture's, shrunk where a side is too long for
/// nearly every screen, with room for the menu and for the mouse. minifb does not know the
/// size of this screen.
fn window_size(picture: Size) -> (usize, usize) {
    let (width, height) = (f64::from(picture.width()), f64::from(picture.height()));
    let fit = (1280.0 / width).min(720.0 / height).min(1.0);
    let side = |side: f64, smallest: f64| (side * fit).round().max(smallest) as usize;
    let bar = menu_bar::HEIGHT as usize;
    (side(width, 240.0), side(height, 120.0) + bar)
}

fn explain(error: minifb::Error) -> NotShown {
    NotShown::NoWindow(match error {
        minifb::Error::WindowCreate(reason) => format!("no display to open it on ({reason})"),
        error => format!("the display refused the picture ({error})"),
    })
}
