//! The size in which the window opens.

use common::Size;

use crate::window::menu_bar::{LINE, PLATFORM_HAS_MENU};

/// Width and height that fit on nearly every screen; how large this one is, is
/// not told.
const LARGEST: (f64, f64) = (1280.0, 720.0);
/// Width and height that leave room for the menu and something to grasp.
const SMALLEST: (f64, f64) = (240.0, 120.0);

/// The picture's width and height and the menu bar, shrunk where a side is too
/// long for the screen, but never too small to use.
pub(super) fn window_size(picture: Size) -> (usize, usize) {
    let (width, height) = (f64::from(picture.width()), f64::from(picture.height()));
    let fit = (LARGEST.0 / width).min(LARGEST.1 / height).min(1.0);
    let side = |side: f64, smallest: f64| (side * fit).round().max(smallest) as usize;
    let bar = if PLATFORM_HAS_MENU { 0 } else { LINE as usize };
    (side(width, SMALLEST.0), side(height, SMALLEST.1) + bar)
}
