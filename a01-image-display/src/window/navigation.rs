//! The effect of the mouse, of the arrow keys and of the keys that lead back.

use std::time::{Duration, Instant};

use program::Gallery;

use super::screen::{Page, Screen};

/// The longest time between the two clicks of a double click.
const DOUBLE: Duration = Duration::from_millis(400);
/// The longest distance, in pixels, between the places where the button of a click goes down
/// and up, and between those of the two clicks of a double click.
const STILL: i32 = 3;
/// Pixels of the mouse's way for an arrow key.
const WAY: i32 = 20;

/// Whether the mouse has hardly moved.
fn is_still(way: [i32; 2]) -> bool {
    way.iter().all(|way| way.abs() <= STILL)
}

impl Screen {
    /// Moves, zooms, rotates or explains the picture, scrolls, and goes back. False if the window is
    /// to be closed.
    pub fn navigate(&mut self, gallery: &mut Gallery) -> bool {
        let (mouse, before) = (self.ui.mouse, self.ui.before);
        let way = mouse.way_from(before.at);
        if self.ui.clicked(self.placement.area) {
            self.pressed = Some(mouse.at);
        }
        if let Some(pressed) = self.pressed {
            self.placement.pan(way);
            if !mouse.left {
                self.pressed = None;
                if is_still(mouse.way_from(pressed)) {
                    self.click(gallery);
                }
            }
        }
        if mouse.right && before.right && way != [0; 2] {
            gallery.rotate(way);
        }
        let lines = mouse.lines_since(before);
        if self.ui.panel.contains(mouse.at) {
            self.ui.scroll_by(-self.ui.px(60.0) * lines);
        } else if lines != 0 {
            self.placement.zoom(lines > 0, mouse.at);
        }
        for (key, lines) in [("PageUp", -8), ("PageDown", 8)] {
            if self.ui.typed(key) {
                self.ui.scroll_by(self.ui.px(20.0) * lines);
            }
        }
        for (key, x, y) in [
            ("Left", -1, 0),
            ("Right", 1, 0),
            ("Up", 0, -1),
            ("Down", 0, 1),
        ] {
            if self.ui.typed(&format!("Ctrl {key}")) {
                gallery.rotate([x, y].map(|way| WAY * way));
            } else if self.ui.typed(&format!("Shift {key}")) {
                self.placement.pan([x, y].map(|way| -WAY * way));
            } else if self.ui.typed(key) {
                self.go_on([x, y], gallery);
            }
        }
        if self.ui.typed("Backspace") {
            self.go_back(gallery);
        }
        !self.ui.typed("Escape") || self.go_back(gallery)
    }

    /// Leaves what was chosen last: the menu, the selected slider, or the explained pixel. False if
    /// there is none of them.
    fn go_back(&mut self, gallery: &mut Gallery) -> bool {
        if self.page() == Some(Page::Menu) {
            self.leave_page();
        } else if self.ui.leave() {
            // The slider stays in the panel.
        } else if gallery.pixel.is_some() {
            gallery.explain(None);
            if self.page() == Some(Page::Pixel) {
                self.leave_page();
            }
        } else {
            return false;
        }
        true
    }

    /// Explains the pixel under the mouse; a double click fits the picture into the window.
    fn click(&mut self, gallery: &mut Gallery) {
        if let Some((time, place)) = self.clicked.take()
            && time.elapsed() < DOUBLE
            && is_still(self.ui.mouse.way_from(place))
        {
            return self.placement.fit();
        }
        self.clicked = Some((Instant::now(), self.ui.mouse.at));
        self.explain(gallery);
    }

    /// Explains the pixel under the mouse, or in the middle.
    pub fn explain(&mut self, gallery: &mut Gallery) {
        let size = gallery.size();
        let middle = [size.width() / 2, size.height() / 2];
        let pixel = self.placement.pixel(self.ui.mouse.at);
        gallery.explain(Some(pixel.unwrap_or(middle)));
        self.show_page(Page::Pixel);
    }

    /// Goes to the next pixel, if one is explained, or else to the next scene.
    fn go_on(&mut self, way: [i32; 2], gallery: &mut Gallery) {
        if let Some(pixel) = gallery.pixel {
            let last = [gallery.size().width() - 1, gallery.size().height() - 1];
            let moved = |axis: usize| pixel[axis].saturating_add_signed(way[axis]).min(last[axis]);
            gallery.explain(Some([0, 1].map(moved)));
        } else if way[0] != 0 {
            let count = gallery.names().len() as i32;
            let number = (gallery.number() as i32 + way[0]).rem_euclid(count);
            self.go_to(number as usize, gallery);
        }
    }
}
