//! `window`: a loop that shows a picture while it is rendered, asks for keys and clicks, and ends.
//!
//! [minifb](https://docs.rs/minifb) opens a window of the system, takes packed pixels, and says
//! which keys and buttons are down. All stages show their scenes in this window.

mod dialog;
mod frame;
mod input;
mod placement;
mod screen;
#[cfg(all(unix, not(target_os = "macos")))]
mod x_display;

use std::time::{Duration, Instant};

use command_line::{Gallery, NotShown};
use common::Size;
use minifb::{Key, ScaleMode, Window, WindowOptions};

use dialog::Dialog;
use input::{Event, Input};
use screen::Screen;

/// How often in a second the loop asks for keys and clicks while somebody uses the window, and else.
const OFTEN: usize = 60;
const RARELY: usize = 10;

/// A window without the keyboard is still used for this time after the mouse has moved over it.
const USED: Duration = Duration::from_secs(2);

/// A picture that grows is drawn again after this time.
const GROWN: Duration = Duration::from_millis(50);

/// So is one that does not: another window may have covered it, of which minifb does not tell.
const COVERED: Duration = Duration::from_millis(500);

// ANCHOR: show
/// Shows the scenes of a gallery until the window is closed.
pub fn show(gallery: &mut Gallery) -> Result<(), NotShown> {
    gallery.read_picture_file()?;
    let mut title = gallery.title();
    let mut window = open(&title, gallery.picture().size())?;
    let mut input = Input::of(&mut window);
    let mut screen = Screen::default();
    let mut dialog = None;
    if gallery.asks_for_file() {
        Dialog::open(&mut dialog, gallery);
    }
    let (mut drawn, mut changes) = (Instant::now(), 0);
    let mut used = Instant::now();
    gallery.begin()?;
    while window.is_open() {
        let is_used = window.is_active() || used.elapsed() < USED;
        window.set_target_fps(if is_used { OFTEN } else { RARELY });
        let events = input.events(&window);
        if !events.is_empty() {
            used = Instant::now();
        }
        for event in &events {
            if !obey(*event, input.at, &mut screen, gallery, &mut dialog) {
                return Ok(());
            }
        }
        let is_answered = Dialog::is_answered(&mut dialog, gallery);
        let is_finished = gallery.update();
        let (width, height) = window.get_size();
        let is_placed = screen.place((width, height), gallery.picture().size());
        let is_new = is_answered || is_finished || is_placed || !events.is_empty();
        let has_grown = gallery.picture().changes() != changes;
        let wait = if is_new {
            Duration::ZERO
        } else if has_grown {
            GROWN
        } else {
            COVERED
        };
        let is_hidden = width == 0 || height == 0;
        if drawn.elapsed() < wait || is_hidden {
            window.update();
            continue;
        }
        (drawn, changes) = (Instant::now(), gallery.picture().changes());
        if title != gallery.title() {
            title = gallery.title();
            window.set_title(&title);
        }
        if is_new || has_grown || gallery.is_rendering() {
            screen.draw(gallery, input.at);
        }
        let shown = window.update_with_buffer(&screen.frame.pixels, width, height);
        shown.map_err(no_window)?;
    }
    Ok(())
}
// ANCHOR_END: show

// ANCHOR: obey
/// Does what a person wants who points there. False if the window is to be closed.
fn obey(
    event: Event,
    at: [i32; 2],
    screen: &mut Screen,
    gallery: &mut Gallery,
    dialog: &mut Option<Dialog>,
) -> bool {
    match event {
        Event::Click => match screen.key_at(at) {
            Some(key) => return obey(Event::Key(key), at, screen, gallery, dialog),
            None => explain(at, screen, gallery),
        },
        Event::Wheel(steps) => gallery.approach(steps),
        Event::Drag(way) => gallery.rotate(way),
        Event::Key(Key::Escape) => return Dialog::delays_end(dialog, gallery),
        Event::Key(Key::S) => Dialog::save(dialog, gallery),
        Event::Key(Key::O) if gallery.opens_pictures() => Dialog::open(dialog, gallery),
        Event::Key(Key::Left) => gallery.go_on(-1),
        Event::Key(Key::Right) => gallery.go_on(1),
        Event::Key(Key::E) => explain(at, screen, gallery),
        Event::Key(Key::R) => gallery.reset(),
        Event::Key(Key::C) => gallery.print_camera(),
        Event::Key(Key::F) => gallery.change_renderer(),
        Event::Key(Key::H) => screen.lists_keys = !screen.lists_keys,
        Event::Move => gallery.point(),
        Event::Key(_) => {}
    }
    true
}

/// Explains the pixel there; beside the picture none.
fn explain(at: [i32; 2], screen: &mut Screen, gallery: &mut Gallery) {
    screen.lists_keys = false;
    match screen.placement.pixel_at(at) {
        Some(pixel) => gallery.explain(pixel),
        None => gallery.forget(),
    }
}
// ANCHOR_END: obey

/// Opens a window for a picture.
fn open(title: &str, picture: Size) -> Result<Window, NotShown> {
    let options = WindowOptions {
        resize: true,
        scale_mode: ScaleMode::UpperLeft,
        ..WindowOptions::default()
    };
    #[cfg(all(unix, not(target_os = "macos")))]
    let display = x_display::check()?;
    #[cfg(not(all(unix, not(target_os = "macos"))))]
    let display: Option<((), [u16; 2])> = None;
    let screen = display.as_ref().map_or([0; 2], |(_, sides)| *sides);
    let (width, height) = screen::window_size(picture, screen);
    let mut window = Window::new(title, width, height, options).map_err(no_window)?;
    // On a Mac, a click before the first update would end the program.
    window.update();
    Ok(window)
}

fn no_window(error: minifb::Error) -> NotShown {
    NotShown::NoWindow(match error {
        minifb::Error::WindowCreate(reason) => format!("no display to open it on ({reason})"),
        error => format!("the display refused the picture ({error})"),
    })
}
