//! The size in which the window opens.

use common::Size;

use super::menu_bar;

/// Width and height that fit on nearly every screen; minifb does not know the size of
/// this one.
const LARGEST: (f64, f64) = (1280.0, 720.0);
/// Width and height with room for the menu and for the mouse.
const SMALLEST: (f64, f64) = (240.0, 120.0);

/// The picture's width and height, shrunk where a side is too long for the screen, and
/// the height of the menu bar.
pub fn window_size(picture: Size) -> (usize, usize) {
    let (width, height) = (f64::from(picture.width()), f64::from(picture.height()));
    let fit = (LARGEST.0 / width).min(LARGEST.1 / height).min(1.0);
    let side = |side: f64, smallest: f64| (side * fit).round().max(smallest) as usize;
    let bar = menu_bar::HEIGHT as usize;
    (side(width, SMALLEST.0), side(height, SMALLEST.1) + bar)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_window_fits_the_screen_and_is_never_too_small() {
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
            let height = height - menu_bar::HEIGHT as usize;
            assert_eq!((width, height), expected, "{picture:?}");
        }
    }
}
