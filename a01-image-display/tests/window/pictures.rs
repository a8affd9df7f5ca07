//! The part of a picture that the window shows.

use common::picture_file;
use testing::display::{Display, Picture};

use super::{folder, locked, locked_file, program, wait_for_picture};

const BACKGROUND: u32 = 0x18_1818;
const RED: u32 = 0xFF_0000;

/// Left, top, right and bottom of the pixels below the menu bar that are not
/// background; the last two are the first pixels beyond.
fn frame(look: &Picture) -> [u32; 4] {
    let shown = look.below_bar();
    let places = (0..shown.height).flat_map(|y| (0..shown.width).map(move |x| (x, y)));
    let places: Vec<_> = places
        .filter(|(x, y)| shown.at(*x, *y) != BACKGROUND)
        .collect();
    let (columns, rows) = (places.iter().map(|p| p.0), places.iter().map(|p| p.1));
    let first = [columns.clone().min(), rows.clone().min()].map(|side| side.unwrap_or(0));
    let last = [columns.max(), rows.max()].map(|side| side.map_or(0, |side| side + 1));
    [first[0], first[1], last[0], last[1]]
}

#[test]
fn every_scene_is_shown_pixel_for_pixel() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    for scene in ["diagonal", "painter"] {
        let window = display.start(&mut program(folder.path(), &format!("show {scene}")));
        assert_eq!(window.title(), format!("a01-image-display: {scene}"));
        assert_eq!(window.size(), (640, 480 + Picture::LINE));
        wait_for_picture(&window, scene);
    }
    let card = locked_file("show-image");
    let line = format!("show show-image --open {}", card.display());
    let window = display.start(&mut program(folder.path(), &line));
    assert_eq!(window.look().notices(), [""; 0], "a file was named");
    wait_for_picture(&window, "show-image");
    assert_eq!(folder.path().read_dir().unwrap().count(), 0, "no file");
}

#[test]
fn a_larger_window_enlarges_by_a_whole_factor() {
    let Some(display) = Display::open(1600, 1300) else {
        return;
    };
    let picture = locked("painter");
    let folder = folder();
    let mut window = display.start(&mut program(folder.path(), "show painter"));
    // Twice 640x480 fits, and 100 pixels to the right and 40 below are left.
    window.resize(1380, 1000 + Picture::LINE);
    let doubled = Picture::from_fn(1280, 960, |x, y| picture.at(x / 2, y / 2));
    let look = window.wait_to_show("the picture twice as large", |look| {
        look.below_bar().part(50, 20, 1280, 960) == doubled
    });
    assert_eq!(frame(&look), [50, 20, 1330, 980]);
    // A pixel less than three times as large.
    window.resize(1600, 1439 - 200 + Picture::LINE);
    let look = window.wait_to_show("the picture in the middle", |look| {
        look.below_bar().part(160, 139, 1280, 960) == doubled
    });
    assert_eq!(frame(&look), [160, 139, 1440, 1099]);
}

#[test]
fn a_smaller_window_shrinks_and_keeps_the_proportions() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let picture = locked("painter");
    let folder = folder();
    let mut window = display.start(&mut program(folder.path(), "show painter"));
    wait_for_picture(&window, "painter");
    window.resize(320, 240 + Picture::LINE);
    // The middle of a pixel lies where four pixels of the picture meet; the
    // one to the lower right is shown.
    let half = Picture::from_fn(320, 240, |x, y| picture.at(2 * x + 1, 2 * y + 1));
    window.wait_to_show("the picture half as large", |look| look.below_bar() == half);
    // As wide as the window: 300 : 640 * 480 = 225 rows, 87.5 above and below.
    window.resize(300, 400 + Picture::LINE);
    window.wait_to_show("the picture as wide as the window", |look| {
        frame(look) == [0, 87, 300, 312]
    });
    // As high as the window: 120 : 480 * 640 = 160 columns.
    window.resize(700, 120 + Picture::LINE);
    window.wait_to_show("the picture as high as the window", |look| {
        frame(look) == [270, 0, 430, 120]
    });
}

#[test]
fn a_window_of_one_pixel_is_no_trouble() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let mut window = display.start(&mut program(folder.path(), "show painter"));
    window.press("h i F10");
    for (width, height) in [(1, 1), (1, 600), (800, 1), (7, 19)] {
        window.resize(width, height);
        // The menu bar comes last; it is above everything.
        window.wait_to_show("the open menu", |look| look.at(0, 0) == 0x3D_5A80);
    }
    window.press("Escape h i");
    window.resize(640, 480 + Picture::LINE);
    wait_for_picture(&window, "painter");
}

#[test]
fn a_picture_larger_than_the_screen_is_shrunk() {
    let Some(display) = Display::open(1400, 800) else {
        return;
    };
    let folder = folder();
    let window = display.start(&mut program(folder.path(), "show painter --size 3000x2000"));
    // 720 rows are the most; 720 : 2000 * 3000 = 1080.
    assert_eq!(window.size(), (1080, 720 + Picture::LINE));
    // 60 / 2000 of the side is lost nowhere: the corners hold the gradient's ends.
    window.wait_to_show("the whole picture", |look| {
        let shown = look.below_bar();
        let corners = [shown.at(0, 0), shown.at(1079, 0), shown.at(1079, 719)];
        corners == [0x00_00FF, 0x00_FFFF, 0x00_FF00] && shown.at(540, 360) == RED
    });
}

#[test]
fn pictures_of_few_pixels_are_large_enough_to_be_seen() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    // The window is at least 240x120, in which the picture is enlarged.
    for (size, expected) in [
        ("1x1", [60, 0, 180, 120]),
        ("1x50", [119, 10, 121, 110]),
        ("50x1", [20, 58, 220, 62]),
    ] {
        let line = format!("show diagonal --size {size}");
        let window = display.start(&mut program(folder.path(), &line));
        assert_eq!(window.size(), (240, 120 + Picture::LINE));
        let look = window.wait_to_show(size, |look| frame(look) == expected);
        let [left, top, ..] = expected;
        assert_eq!(look.below_bar().at(left, top), RED, "{size}");
    }
}

#[test]
fn a_file_of_any_size_gets_a_window_of_its_size() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let path = folder.path().join("small.png");
    let size = common::Size::new(300, 200).unwrap();
    let image = common::Image::from_fn(size, |x, y| {
        common::Color::from_packed(x * 0x1_0003 + y * 0x101)
    });
    let image = image.unwrap();
    picture_file::save_png(&path, size, &image.to_rgb8(common::Transfer::Linear)).unwrap();
    let line = "show show-image --open small.png";
    let window = display.start(&mut program(folder.path(), line));
    assert_eq!(window.size(), (300, 200 + Picture::LINE));
    let expected = Picture::from(&image);
    window.wait_to_show("the file", |look| look.below_bar() == expected);
}
