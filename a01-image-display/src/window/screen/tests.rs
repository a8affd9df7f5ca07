//! Tests of `screen`.

use super::*;

/// Without a menu of the platform's, 18 rows are the bar's.
#[test]
fn a_window_is_as_large_as_its_picture_but_for_the_screen() {
    for (picture, expected) in [
        ((640, 480), (640, 480)),
        ((1280, 720), (1280, 720)),
        ((3000, 2000), (1080, 720)),
        ((2560, 720), (1280, 360)),
        ((1281, 1), (1280, 120)),
        ((1, 1), (240, 120)),
        ((241, 119), (241, 120)),
    ] {
        let (width, height) = window_size(Size::new(picture.0, picture.1).unwrap());
        let bar = if PLATFORM_HAS_MENU { 0 } else { 18 };
        assert_eq!((width, height - bar), expected, "{picture:?}");
    }
}

#[test]
fn why_there_is_no_window_is_told() {
    let reason = |error| explain(error).to_string();
    let none = reason(minifb::Error::WindowCreate("none".to_owned()));
    assert_eq!(none, "no display to open it on (none)");
    let refused = reason(minifb::Error::UpdateFailed("full".to_owned()));
    assert!(refused.starts_with("the display refused the picture ("));
}
