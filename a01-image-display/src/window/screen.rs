//! `Screen`: the open window and its picture.

mod commands;
mod size;

use std::thread::Scope;
use std::time::{Duration, Instant};

use common::{Error, Image, Size};
use minifb::{Menu, MouseMode, ScaleMode, WindowOptions};
use program::{Gallery, LivePicture, NotShown, Rendering};

use super::frame::Frame;
use super::keyboard::Keyboard;
use super::menu_bar::{ITEMS, MenuBar, PLATFORM_HAS_MENU};
use super::placement::Zoom;

use commands::{After, Mouse};
use size::window_size;

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
    pub(super) window: minifb::Window,
    keyboard: Keyboard,
    is_active: bool,
    mouse: Mouse,
    pub(super) menu: MenuBar,
    pub(super) frame: Frame,
    pub(super) title: String,
    pub(super) size: Size,
    /// The finished picture as it is shown.
    pub(super) pixels: Vec<u32>,
    /// The finished picture as it is saved, or the reason for its absence; none while it
    /// is rendered.
    pub(super) outcome: Option<Result<Image, String>>,
    pub(super) zoom: Zoom,
    pub(super) inspects: bool,
    pub(super) helps: bool,
    notice: Option<(String, Instant)>,
}

/// The state that is visible in the window. If it changes, the window is redrawn.
#[derive(PartialEq)]
struct Look {
    rows: Option<u32>,
    elapsed: Option<u64>,
    has_notice: bool,
    menu: Option<usize>,
    window: (usize, usize),
    cursor: Option<(i32, i32)>,
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
        let mut menu = MenuBar::default();
        menu.can_open = gallery.opens_files();
        if PLATFORM_HAS_MENU {
            add_platform_menu(&mut window);
        }
        Ok(Self {
            window,
            keyboard,
            menu,
            frame: Frame::default(),
            title,
            is_active: false,
            mouse: Mouse::default(),
            size,
            pixels: Vec::new(),
            outcome: None,
            zoom: Zoom::Fit,
            inspects: false,
            helps: false,
            notice: None,
        })
    }

    /// Shows the picture and executes commands until the window is closed.
    pub fn run<'scope, 'a: 'scope>(
        &mut self,
        scope: &'scope Scope<'scope, '_>,
        gallery: &mut Gallery<'a>,
        mut rendering: Option<Rendering<'scope>>,
    ) -> Result<(), NotShown> {
        let (mut drawn, mut drawn_at) = (None, Instant::now());
        while self.window.is_open() {
            if rendering.as_ref().is_some_and(Rendering::is_over) {
                if let Some(outcome) = rendering.take().map(Rendering::join) {
                    self.finish(gallery, outcome);
                }
                drawn = None;
            }
            for command in self.commands() {
                drawn = None;
                match self.execute(command, gallery) {
                    After::Nothing => {}
                    After::Close => return Ok(()),
                    After::Render => {
                        // The old rendering, if there is one, stops.
                        rendering = None;
                        match gallery.render(scope) {
                            Ok(new) => rendering = Some(new),
                            Err(error) => self.finish(gallery, Err(error)),
                        }
                    }
                }
            }
            let live = rendering.as_ref().map(Rendering::picture);
            let look = self.look(live);
            let is_drawn = drawn.as_ref() == Some(&look);
            if drawn_at.elapsed() < if is_drawn { REFRESH } else { FRAME } {
                self.window.update();
                continue;
            }
            let (width, height) = look.window;
            if !is_drawn {
                self.draw(live, look.cursor);
                drawn = Some(look);
            }
            self.window
                .update_with_buffer(self.frame.pixels(), width, height)
                .map_err(explain)?;
            drawn_at = Instant::now();
        }
        Ok(())
    }

    /// Shows a finished picture, or an error.
    pub fn finish(&mut self, gallery: &Gallery, outcome: Result<Image, Error>) {
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

    fn look(&self, live: Option<&LivePicture>) -> Look {
        Look {
            rows: live.map(LivePicture::rows),
            elapsed: live.map(|live| live.elapsed().as_secs()),
            has_notice: self.notice().is_some(),
            menu: self.menu.selected(),
            window: self.window.get_size(),
            cursor: self.cursor().filter(|_| self.inspects),
        }
    }

    fn cursor(&self) -> Option<(i32, i32)> {
        let cursor = self.window.get_mouse_pos(MouseMode::Discard);
        cursor.map(|(x, y)| (x as i32, y as i32))
    }
}

fn add_platform_menu(window: &mut minifb::Window) {
    if let Ok(mut file) = Menu::new("File") {
        for (id, item) in ITEMS.into_iter().enumerate() {
            file.add_item(item.label, id).build();
        }
        window.add_menu(&file);
    }
}

fn explain(error: minifb::Error) -> NotShown {
    NotShown::NoWindow(match error {
        minifb::Error::WindowCreate(reason) => format!("no display to open it on ({reason})"),
        error => format!("the display refused the picture ({error})"),
    })
}
