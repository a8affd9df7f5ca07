//! The size of the window, and the part of a picture that it shows.

use crate::display::{BAR, picture};
use common::{Color, Image, Size, Transfer, picture_file};

use super::{locked, locked_file, packed, wait_for_picture, with_window};

const BACKGROUND: u32 = 0x18_1818;

#[test]
fn a_file_is_shown_pixel_for_pixel() {
    let card = locked_file("show-image");
    let line = format!("show show-image --open {}", card.display());
    with_window(&line, |window, _| wait_for_picture(&window, "show-image"));

    let file = tempfile::Builder::new().suffix(".png").tempfile().unwrap();
    let size = Size::new(300, 200).unwrap();
    let image = Image::from_fn(size, |x, y| Color::from_packed(x * 0x1_0003 + y * 0x101)).unwrap();
    picture_file::save_png(file.path(), size, &image.to_rgb8(Transfer::Linear)).unwrap();
    let line = format!("show show-image --open {}", file.path().display());
    with_window(&line, |window, _| {
        window.wait_for(&[&picture(300, 200, |x, y| packed(&image, x, y))]);
    });
}

#[test]
fn a_window_fits_the_screen_and_is_never_too_small() {
    for (picture, width, height) in [
        ("640x480", 640, 480),
        ("3000x2000", 1080, 720),
        ("1281x1", 1280, 120),
        ("1x1", 240, 120),
    ] {
        with_window(&format!("show painter --size {picture}"), |window, _| {
            let height = height + BAR;
            window.wait_for(&[&format!("window: ({width}, {height})")]);
        });
    }
}

#[test]
fn a_resized_window_enlarges_and_shrinks_the_picture() {
    let painter = locked("painter");
    with_window("show painter", |window, _| {
        let resize = |width, height| {
            window.act(&format!("windowsize WINDOW {width} {height}"));
            window.wait_for(&[&format!("window: ({width}, {height})")]);
        };
        // Twice 640x480 fits, and 100 pixels to the right and 40 below are left.
        resize(1380, 1000 + BAR);
        let doubled = |x: u32, y: u32| {
            let is_beside = !(50..1330).contains(&x) || !(20..980).contains(&y);
            if is_beside {
                BACKGROUND
            } else {
                packed(&painter, (x - 50) / 2, (y - 20) / 2)
            }
        };
        window.wait_for(&[&picture(1380, 1000, doubled)]);
        // The middle of a pixel lies where four pixels of the picture meet; the one to
        // the lower right is shown.
        resize(320, 240 + BAR);
        let half = |x, y| packed(&painter, 2 * x + 1, 2 * y + 1);
        window.wait_for(&[&picture(320, 240, half)]);
        window.press("h i F10");
        window.wait_for(&["menu: Some(0)"]);
        for (width, height) in [(1, 1), (1, 600), (800, 1), (7, 19)] {
            resize(width, height);
        }
    });
}
