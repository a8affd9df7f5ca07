//! The effect of the mouse and of the arrow keys on the picture.

use std::time::{Duration, Instant};

use program::Gallery;

use super::screen::{Page, Screen};

/// The longest time between the two clicks of a double click.
const DOUBLE: Duration = Duration::from_millis(400);
/// The longest distance, in pixels, between the places where the button of a click goes down
/// and up.
const STILL: i32 = 3;
/// Pixels of the mouse's way for an arrow key.
const WAY: i32 = 20;

impl Screen {
    /// Moves, zooms, turns or explains the picture.
    pub fn handle(&mut self, gallery: &mut Gallery) {
        let (mouse, before) = (self.ui.mouse, self.ui.before);
        let way = mouse.way_from(before.at);
        if self.ui.clicked(self.placement.area) {
            self.pressed = Some(mouse.at);
        }
        if let Some(pressed) = self.pressed {
            self.placement.pan(way);
            if !mouse.left {
                self.pressed = None;
                if mouse.way_from(pressed).iter().all(|way| way.abs() <= STILL) {
                    self.click(gallery);
                }
            }
        }
        if mouse.right && before.right && way != [0; 2] {
            gallery.turn(way);
        }
        let steps = mouse.steps_since(before);
        if self.ui.panel.contains(mouse.at) {
            self.ui.scroll -= self.ui.px(60.0) * steps;
        } else if steps != 0 {
            self.placement.zoom(steps > 0, mouse.at);
        }
        for (key, x, y) in [
            ("Left", -1, 0),
            ("Right", 1, 0),
            ("Up", 0, -1),
            ("Down", 0, 1),
        ] {
            if self.ui.typed(&format!("Ctrl {key}")) {
                gallery.turn([x, y].map(|way| WAY * way));
            } else if self.ui.typed(&format!("Shift {key}")) {
                self.placement.pan([x, y].map(|way| -WAY * way));
            } else if self.ui.typed(key) {
                self.go_on([x, y], gallery);
            }
        }
    }

    /// Explains the pixel under the mouse; a double click fits the picture into the window.
    fn click(&mut self, gallery: &mut Gallery) {
        let first = self.clicked.take();
        if first.is_some_and(|first| first.elapsed() < DOUBLE) {
            return self.placement.fit();
        }
        self.clicked = Some(Instant::now());
        self.explain(gallery);
    }

    /// Explains the pixel under the mouse, or in the middle.
    pub fn explain(&mut self, gallery: &mut Gallery) {
        let size = gallery.size();
        let middle = [size.width() / 2, size.height() / 2];
        let pixel = self.placement.pixel(self.ui.mouse.at);
        gallery.explain(Some(pixel.unwrap_or(middle)));
        (self.page, self.ui.selected) = (Some(Page::Pixel), None);
    }

    /// Goes to the next pixel, if one is explained, or else to the next scene.
    fn go_on(&mut self, way: [i32; 2], gallery: &mut Gallery) {
        if let Some(pixel) = gallery.pixel {
            let last = [gallery.size().width() - 1, gallery.size().height() - 1];
            let moved = |axis: usize| pixel[axis].saturating_add_signed(way[axis]).min(last[axis]);
            gallery.explain(Some([0, 1].map(moved)));
        } else if way[0] != 0 {
            let count = gallery.stage.scenes.len() as i32;
            let number = (gallery.number() as i32 + way[0]).rem_euclid(count);
            self.go_to(number as usize, gallery);
        }
    }
}
