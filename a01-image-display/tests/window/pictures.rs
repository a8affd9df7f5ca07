//! The size of the window, and the part of a picture that it shows.

use common::{Color, Image, Size, Transfer, picture_file};
use testing::display::Picture;

use super::{locked, locked_file, wait_for_picture, with_window, with_window_in};

const BACKGROUND: u32 = 0x18_1818;

#[test]
fn a_picture_is_shown_pixel_for_pixel() {
    with_window("", |window, folder| {
        assert_eq!(window.title(), "a01-image-display: diagonal");
        assert_eq!(window.size(), (640, 480 + Picture::LINE));
        wait_for_picture(&window, "diagonal");
        assert_eq!(folder.read_dir().unwrap().count(), 0, "no file");
    });
    let card = locked_file("show-image");
    let line = format!("show show-image --open {}", card.display());
    with_window(&line, |window, _| wait_for_picture(&window, "show-image"));

    let folder = tempfile::tempdir().unwrap();
    let size = Size::new(300, 200).unwrap();
    let image = Image::from_fn(size, |x, y| Color::from_packed(x * 0x1_0003 + y * 0x101)).unwrap();
    let path = folder.path().join("small.png");
    picture_file::save_png(&path, size, &image.to_rgb8(Transfer::Linear)).unwrap();
    let line = "show show-image --open small.png";
    with_window_in(folder.path(), line, [800, 600], |window| {
        assert_eq!(window.size(), (300, 200 + Picture::LINE));
        let expected = Picture::from(&image);
        window.wait_to_show("the file", |look| look.below_bar() == expected);
    });
}

#[test]
fn a_resized_window_enlarges_and_shrinks_the_picture() {
    let picture = locked("painter");
    let folder = tempfile::tempdir().unwrap();
    with_window_in(folder.path(), "show painter", [1600, 1300], |mut window| {
        // Twice 640x480 fits, and 100 pixels to the right and 40 below are left.
        window.resize(1380, 1000 + Picture::LINE);
        let doubled = Picture::from_fn(1380, 1000, |x, y| {
            let is_beside = !(50..1330).contains(&x) || !(20..980).contains(&y);
            if is_beside {
                BACKGROUND
            } else {
                picture.at((x - 50) / 2, (y - 20) / 2)
            }
        });
        window.wait_to_show("the picture twice as large", |look| {
            look.below_bar() == doubled
        });
        // The middle of a pixel lies where four pixels of the picture meet; the one to
        // the lower right is shown.
        window.resize(320, 240 + Picture::LINE);
        let half = Picture::from_fn(320, 240, |x, y| picture.at(2 * x + 1, 2 * y + 1));
        window.wait_to_show("the picture half as large", |look| look.below_bar() == half);
        window.press("h i F10");
        for (width, height) in [(1, 1), (1, 600), (800, 1), (7, 19)] {
            window.resize(width, height);
            window.wait_to_show("the open menu", |look| look.at(0, 0) == 0x3D_5A80);
        }
    });
}
