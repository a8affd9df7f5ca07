//! Inputs and the state of the screen after them, without a display.

use std::ffi::OsString;
use std::process::ExitCode;

use common::Error;
use program::{Gallery, NotShown};
use winit::event::{ElementState, MouseButton};

use super::keyboard::Press;
use super::screen::{Page, Screen};

/// Ends the program of this stage as a failure, so that a test sees whether its viewer has run.
const RUN: Result<(), NotShown> = Err(NotShown::Failed(Error::Stopped));

/// Runs the program with a viewer that tests a screen.
fn view(scene: &str, viewer: program::Viewer) {
    let line = ["a01-image-display", "show", scene].map(OsString::from);
    let code = program::run_with(&crate::stage(), Some(viewer), line);
    assert_eq!(
        code,
        ExitCode::from(Error::Stopped.exit_code()),
        "it was viewed"
    );
}

/// A screen of the size at which the window opens, with a finished picture.
fn screen(gallery: &mut Gallery) -> Screen {
    gallery.wait();
    let mut screen = Screen::default();
    screen.begin(gallery, None, 1.0);
    screen.draw(gallery);
    screen
}

/// Presses keys in turn. A letter types itself. False if the window is to be closed.
fn press(screen: &mut Screen, gallery: &mut Gallery, keys: &str) -> bool {
    keys.split_whitespace().all(|key| {
        let text = if key.chars().count() == 1 { key } else { "" };
        let press = Press {
            key: key.to_uppercase().replace("CTRL+", "Ctrl "),
            text: text.to_owned(),
        };
        let named = [
            "PageDown",
            "Tab",
            "Escape",
            "Enter",
            "Backspace",
            "Right",
            "Down",
        ];
        let press = match named.iter().find(|name| **name == key) {
            Some(name) => Press {
                key: (*name).to_owned(),
                text: String::new(),
            },
            None => press,
        };
        let mouse = screen.ui.mouse;
        screen.input(press, mouse, gallery)
    })
}

/// Presses and releases the left button at a place, without any time in between.
fn click(screen: &mut Screen, gallery: &mut Gallery, at: [i32; 2]) {
    let mut mouse = screen.ui.mouse;
    mouse.at = at;
    for state in [ElementState::Pressed, ElementState::Released] {
        mouse = mouse.with_button(MouseButton::Left, state);
        assert!(screen.input(Press::default(), mouse, gallery));
    }
}

#[test]
fn escape_and_backspace_lead_back_and_only_escape_closes() {
    view("painter", |gallery| {
        let mut screen = screen(gallery);
        click(&mut screen, gallery, [320, 240]);
        assert_eq!(gallery.pixel, Some([320, 240]));
        assert_eq!(screen.page(), Some(Page::Pixel));
        for back in ["Escape", "Backspace"] {
            assert!(press(&mut screen, gallery, "h"));
            assert_eq!(screen.page(), Some(Page::Menu));
            // An entry is selected, and the menu is left at once.
            assert!(press(&mut screen, gallery, back));
            assert_eq!(screen.page(), Some(Page::Pixel));
        }
        assert!(press(&mut screen, gallery, "Backspace Backspace Backspace"));
        assert_eq!((screen.page(), gallery.pixel), (None, None));
        assert!(
            !press(&mut screen, gallery, "Escape"),
            "the window is closed"
        );
        RUN
    });
}

#[test]
fn tab_selects_and_enter_chooses() {
    view("painter", |gallery| {
        let mut screen = screen(gallery);
        // Neither key is a letter.
        assert!(press(&mut screen, gallery, "Enter Backspace"));
        assert_eq!((screen.page(), gallery.pixel), (None, None));
        assert!(press(&mut screen, gallery, "h Tab Tab"));
        assert_eq!(screen.ui.selected, Some(2));
        assert!(press(&mut screen, gallery, "Enter"));
        assert!(screen.path_entry.is_some(), "the third entry opens a path");
        RUN
    });
}

#[test]
fn a_typed_path_is_opened_and_its_letters_are_no_commands() {
    view("painter", |gallery| {
        let mut screen = screen(gallery);
        assert!(press(
            &mut screen,
            gallery,
            "p h s . p n g Backspace G Enter"
        ));
        assert_eq!((screen.page(), screen.path_entry.is_none()), (None, true));
        assert_eq!(gallery.name(), "show-image");
        gallery.wait();
        let error = gallery.error().expect("there is no such file").to_string();
        assert!(error.contains("hs.pnG"), "{error}");
        assert!(screen.messages(gallery)[0].is_error);
        // Another scene has no error, and a cancelled path changes nothing.
        assert!(press(&mut screen, gallery, "Right p x Escape"));
        gallery.wait();
        assert_eq!(screen.messages(gallery), []);
        RUN
    });
}

#[test]
fn notices_lie_over_a_picture_that_keeps_its_place() {
    view("painter", |gallery| {
        let mut screen = screen(gallery);
        let (placement, before) = (screen.placement, screen.ui.frame.pixels.clone());
        screen.notify_error(&"the disc is full ".repeat(20));
        screen.draw(gallery);
        assert_eq!(screen.placement, placement);
        let after = &screen.ui.frame.pixels;
        assert!(after.contains(&screen.ui.colors.error));
        // The upper half of the picture, without the lines of text, has the same pixels.
        let upper = 640 * 240;
        assert_eq!(after[..upper], before[..upper]);
        screen.notice = None;
        screen.draw(gallery);
        assert_eq!(screen.ui.frame.pixels, before);
        RUN
    });
}

#[test]
fn a_larger_window_enlarges_the_picture() {
    view("painter", |gallery| {
        let mut screen = screen(gallery);
        assert_eq!(screen.placement.scale, 1.0);
        screen.size = [900, 1000];
        screen.draw(gallery);
        assert_eq!(screen.placement.scale, 900.0 / 640.0);
        // Zooming goes to whole factors, and back to the one that fits.
        assert!(press(&mut screen, gallery, "+"));
        assert_eq!(screen.placement.scale, 2.0);
        assert!(press(&mut screen, gallery, "0"));
        assert_eq!(screen.placement.scale, 900.0 / 640.0);
        RUN
    });
}

#[test]
fn a_scroll_bar_shows_and_moves_what_has_no_room() {
    view("painter", |gallery| {
        let mut screen = screen(gallery);
        assert!(press(&mut screen, gallery, "h"));
        screen.draw(gallery);
        let bar = |screen: &Screen| {
            screen
                .ui
                .words
                .iter()
                .any(|word| word.starts_with("scrolled"))
        };
        assert!(bar(&screen));
        click(&mut screen, gallery, [635, 400]);
        assert!(screen.ui.scroll > 0, "a click low in the bar scrolls down");
        // Farther than its last item nothing is scrolled.
        press(&mut screen, gallery, "PageDown PageDown PageDown PageDown");
        let end = screen.ui.scroll;
        screen.draw(gallery);
        assert_eq!(screen.ui.scroll, end);
        screen.size = [640, 1400];
        screen.draw(gallery);
        assert_eq!((bar(&screen), screen.ui.scroll), (false, 0));
        RUN
    });
}
