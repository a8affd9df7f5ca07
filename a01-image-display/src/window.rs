//! `Window`: shows the scenes of a stage while they are rendered.

mod command;
mod frame;
mod keyboard;
mod menu_bar;
mod placement;

use std::thread::Scope;
use std::time::{Duration, Instant};

use common::{Color, Gallery, Image, LivePicture, NotShown, Rendering, Size, Viewer};
use minifb::{Menu, MouseButton, MouseMode, ScaleMode, WindowOptions};

use command::Command;
use frame::{Area, Frame, LETTER};
use keyboard::Keyboard;
use menu_bar::{ITEMS, LINE, MenuBar, PLATFORM_HAS_MENU};
use placement::{Placement, Zoom};

/// Width and height that fit on most screens, their bars included.
const LARGEST: (f64, f64) = (1600.0, 950.0);
/// Width and height that leave room for the menu and something to grasp.
const SMALLEST: (f64, f64) = (240.0, 120.0);

/// Updates a second: of what is typed and of the picture.
const UPDATES: usize = 60;
/// After this time the window is drawn although nothing has changed: another
/// window may have covered it.
const REFRESH: Duration = Duration::from_millis(250);
/// How long a notice stays.
const NOTICE: Duration = Duration::from_secs(6);

const NO_FILE: &str = "no file was chosen; the argument --open FILE shows one, too";

const BACKGROUND: u32 = 0x18_1818;
const STRIP: u32 = 0x2B_2B2B;
const DONE: u32 = 0x3D_5A80;
const TEXT: u32 = 0xE0_E0E0;

/// A window that grows with the picture and lets its reader save it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Window;

impl Viewer for Window {
    fn show(&self, gallery: &mut Gallery) -> Result<(), NotShown> {
        let mut has_chosen = true;
        if gallery.opens_files() && !gallery.has_file() {
            match choose_file() {
                Some(file) => gallery.open(file),
                None => has_chosen = false,
            }
        }
        std::thread::scope(|scope| {
            let rendering = gallery.render(scope)?;
            // The size of a file is not known before it has been read.
            let (rendering, image) = if gallery.opens_files() {
                (None, Some(rendering.join()?))
            } else {
                (Some(rendering), None)
            };
            let size = match (&rendering, &image) {
                (Some(rendering), _) => rendering.picture().size(),
                (_, Some(image)) => image.size(),
                _ => Size::COURSE,
            };
            let mut screen = Screen::open(gallery, size)?;
            if let Some(image) = image {
                screen.hang(gallery, image);
            }
            if !has_chosen {
                screen.notify(NO_FILE.to_owned());
            }
            screen.run(scope, gallery, rendering)
        })
    }
}

fn choose_file() -> Option<std::path::PathBuf> {
    rfd::FileDialog::new()
        .set_title("Open a picture")
        .add_filter("pictures", &["png", "jpg", "jpeg", "bmp"])
        .pick_file()
}

/// The open window and what it shows.
struct Screen {
    window: minifb::Window,
    keyboard: Keyboard,
    menu: MenuBar,
    frame: Frame,
    title: String,
    /// The picture as it is shown, and when it is finished also as it is saved.
    size: Size,
    pixels: Vec<u32>,
    image: Option<Image>,
    zoom: Zoom,
    inspects: bool,
    helps: bool,
    notice: Option<(String, Instant)>,
    mouse_was_down: bool,
}

/// What decides whether the window must be drawn again.
#[derive(PartialEq)]
struct Look {
    rows: Option<u32>,
    elapsed: Option<u64>,
    has_notice: bool,
    window: (usize, usize),
    cursor: Option<(i32, i32)>,
}

impl Screen {
    fn open(gallery: &Gallery, size: Size) -> Result<Self, NotShown> {
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
        menu.set_can_open(gallery.opens_files());
        if PLATFORM_HAS_MENU {
            add_platform_menu(&mut window);
        }
        Ok(Self {
            window,
            keyboard,
            menu,
            frame: Frame::default(),
            title,
            size,
            pixels: vec![0; size.pixels()],
            image: None,
            zoom: Zoom::Fit,
            inspects: false,
            helps: false,
            notice: None,
            mouse_was_down: false,
        })
    }

    /// Shows, and obeys, until the window is closed.
    fn run<'scope, 'a: 'scope>(
        &mut self,
        scope: &'scope Scope<'scope, '_>,
        gallery: &mut Gallery<'a>,
        mut rendering: Option<Rendering<'scope>>,
    ) -> Result<(), NotShown> {
        let (mut drawn, mut drawn_at) = (None, Instant::now());
        while self.window.is_open() {
            if rendering.as_ref().is_some_and(Rendering::is_over) {
                match rendering.take().map(Rendering::join) {
                    Some(Ok(image)) => self.hang(gallery, image),
                    Some(Err(error)) => self.notify(format!("error: {error}")),
                    None => {}
                }
                drawn = None;
            }
            for command in self.commands() {
                drawn = None;
                match self.obey(command, gallery) {
                    After::Nothing => {}
                    After::Close => return Ok(()),
                    After::Render => match gallery.render(scope) {
                        // The old rendering, if there is one, stops when it is dropped.
                        Ok(new) => rendering = Some(new),
                        Err(error) => self.notify(format!("error: {error}")),
                    },
                }
            }
            let live = rendering.as_ref().map(Rendering::picture);
            let look = self.look(live);
            if drawn.as_ref() != Some(&look) || drawn_at.elapsed() > REFRESH {
                self.draw(live, look.cursor);
                let (width, height) = look.window;
                let frame = self.frame.pixels();
                self.window
                    .update_with_buffer(frame, width, height)
                    .map_err(explain)?;
                (drawn, drawn_at) = (Some(look), Instant::now());
            } else {
                self.window.update();
            }
        }
        Ok(())
    }

    /// Shows a finished picture.
    fn hang(&mut self, gallery: &Gallery, image: Image) {
        let transfer = gallery.transfer();
        let pack = |color: &Color| transfer.pack(*color);
        self.size = image.size();
        self.pixels = image.pixels().iter().map(pack).collect();
        self.image = Some(image);
    }

    fn notify(&mut self, notice: String) {
        self.notice = Some((notice, Instant::now()));
    }

    fn notice(&self) -> Option<&str> {
        let (notice, since) = self.notice.as_ref()?;
        (since.elapsed() <= NOTICE).then_some(notice)
    }

    fn look(&self, live: Option<&LivePicture>) -> Look {
        Look {
            rows: live.map(LivePicture::rows),
            elapsed: live.map(|live| live.elapsed().as_secs()),
            has_notice: self.notice().is_some(),
            window: self.window.get_size(),
            cursor: self
                .cursor()
                .filter(|_| self.inspects || self.menu.is_open()),
        }
    }

    fn cursor(&self) -> Option<(i32, i32)> {
        let cursor = self.window.get_mouse_pos(MouseMode::Discard);
        cursor.map(|(x, y)| (x as i32, y as i32))
    }

    /// What has been typed, chosen and clicked.
    fn commands(&mut self) -> Vec<Command> {
        let mut commands = Vec::new();
        for typed in self.keyboard.take() {
            commands.extend(self.menu.handle(typed));
        }
        let chosen = self.window.is_menu_pressed().and_then(|id| ITEMS.get(id));
        commands.extend(chosen.map(|item| item.command));

        let down = self.window.get_mouse_down(MouseButton::Left);
        if let Some((x, y)) = self.cursor().filter(|_| !PLATFORM_HAS_MENU) {
            self.menu.hover(x, y);
            if down && !self.mouse_was_down {
                commands.extend(self.menu.click(x, y));
            }
        }
        self.mouse_was_down = down;
        commands
    }

    fn obey(&mut self, command: Command, gallery: &mut Gallery) -> After {
        match command {
            Command::Close => return After::Close,
            Command::Save => self.save(gallery),
            Command::Open if gallery.opens_files() => match choose_file() {
                Some(file) => {
                    gallery.open(file);
                    return self.change_to(gallery);
                }
                None => self.notify(NO_FILE.to_owned()),
            },
            Command::Next => {
                gallery.go_to_next();
                return self.change_to(gallery);
            }
            Command::Previous => {
                gallery.go_to_previous();
                return self.change_to(gallery);
            }
            Command::Inspect => self.inspects = !self.inspects,
            Command::Help => self.helps = !self.helps,
            Command::ZoomIn => self.zoom = self.placement().zoomed_in(self.cursor()),
            Command::ZoomOut => self.zoom = self.placement().zoomed_out(self.cursor()),
            Command::ZoomReset => self.zoom = Zoom::Fit,
            // The menu has handled the rest.
            _ => {}
        }
        After::Nothing
    }

    fn change_to(&mut self, gallery: &Gallery) -> After {
        self.title = gallery.title();
        self.window.set_title(&self.title);
        self.menu.set_can_open(gallery.opens_files());
        self.zoom = Zoom::Fit;
        self.notice = None;
        self.image = None;
        After::Render
    }

    fn save(&mut self, gallery: &Gallery) {
        let notice = match &self.image {
            None => "the picture is not finished yet".to_owned(),
            Some(image) => match gallery.save(image) {
                Ok(path) => format!("saved {}", path.display()),
                Err(error) => format!("error: {error}"),
            },
        };
        self.notify(notice);
    }

    /// Where the picture lies in the window as it is now.
    fn placement(&self) -> Placement {
        let (width, height) = self.window.get_size();
        let bar = if PLATFORM_HAS_MENU { 0 } else { LINE };
        let area = Area {
            x: 0,
            y: bar,
            width: width as i32,
            height: (height as i32 - bar).max(1),
        };
        Placement::new(self.size, area, self.zoom)
    }

    fn draw(&mut self, live: Option<&LivePicture>, cursor: Option<(i32, i32)>) {
        if let Some(live) = live {
            self.size = live.size();
            self.pixels = live.pixels();
        }
        self.frame.clear(self.window.get_size(), BACKGROUND);

        let placement = self.placement();
        let (pixels, width) = (&self.pixels, self.size.width());
        self.frame.paint(placement.area(), |x, y| {
            let (column, row) = placement.pixel(x, y)?;
            pixels.get((row * width + column) as usize).copied()
        });

        let mut lines = Vec::new();
        if self.helps {
            lines.push(command::HELP.to_owned());
        }
        if self.inspects {
            lines.push(self.inspect(placement, cursor));
        }
        lines.extend(self.notice().map(str::to_owned));
        let Area { y, height, .. } = placement.area();
        let mut bottom = y + height;
        if let Some(live) = live {
            bottom -= LINE;
            self.draw_progress(live, bottom);
        }
        for line in lines {
            bottom -= LINE;
            self.draw_line(&line, bottom);
        }
        if !PLATFORM_HAS_MENU {
            let width = placement.area().width;
            self.menu.draw(&mut self.frame, width, &self.title);
        }
    }

    fn inspect(&self, placement: Placement, cursor: Option<(i32, i32)>) -> String {
        let Some((x, y)) = cursor.and_then(|(x, y)| placement.pixel(x, y)) else {
            return "point at the picture".to_owned();
        };
        let packed = self.pixels[(y * self.size.width() + x) as usize];
        let [_, r, g, b] = packed.to_be_bytes();
        format!("column {x}, row {y}: #{packed:06x} ({r}, {g}, {b})")
    }

    fn draw_line(&mut self, text: &str, y: i32) {
        let area = Area {
            x: 0,
            y,
            width: self.placement().area().width,
            height: LINE,
        };
        self.frame.fill(area, STRIP);
        self.frame.text(LETTER, y + 5, TEXT, text);
    }

    fn draw_progress(&mut self, live: &LivePicture, y: i32) {
        let share = f64::from(live.rows()) / f64::from(live.size().height());
        let clock = |time: Duration| format!("{}:{:02}", time.as_secs() / 60, time.as_secs() % 60);
        let remaining = live.remaining().map_or("?".to_owned(), clock);
        let text = format!(
            "{:3.0} %  {} elapsed, {remaining} to go",
            100.0 * share,
            clock(live.elapsed()),
        );
        self.draw_line("", y);
        let width = f64::from(self.placement().area().width) * share;
        let done = Area {
            x: 0,
            y,
            width: width as i32,
            height: LINE,
        };
        self.frame.fill(done, DONE);
        self.frame.text(LETTER, y + 5, TEXT, &text);
    }
}

/// What a command leaves to be done.
enum After {
    Nothing,
    Render,
    Close,
}

fn add_platform_menu(window: &mut minifb::Window) {
    if let Ok(mut file) = Menu::new("File") {
        for (id, item) in ITEMS.into_iter().enumerate() {
            file.add_item(item.label, id).build();
        }
        window.add_menu(&file);
    }
}

/// The picture's width and height and the menu bar, shrunk where a side is too
/// long for the screen; never smaller than what a person can handle.
fn window_size(picture: Size) -> (usize, usize) {
    let (width, height) = (f64::from(picture.width()), f64::from(picture.height()));
    let fit = (LARGEST.0 / width).min(LARGEST.1 / height).min(1.0);
    let side = |side: f64, smallest: f64| (side * fit).round().max(smallest) as usize;
    let bar = if PLATFORM_HAS_MENU { 0 } else { LINE as usize };
    (side(width, SMALLEST.0), side(height, SMALLEST.1) + bar)
}

fn explain(error: minifb::Error) -> NotShown {
    NotShown::NoWindow(match error {
        minifb::Error::WindowCreate(reason) => format!("no display to open it on ({reason})"),
        error => format!("the display refused the picture ({error})"),
    })
}
